package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.auvsml.message.feedback.MeasurementFrame;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Axes;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/**
 * What a recorded robot measured and was told, as the rows of a table: by time, and each row by
 * {@link Slots}, in the simulator's axes.
 */
final class RecordedRows implements RecordedFeedback.Listener {
    private final long id;
    private final List<String> actuators;
    private final long each;
    private final NavigableMap<Double, double[]> measured = new TreeMap<>();
    private final NavigableMap<Double, double[]> told = new TreeMap<>();
    private final Set<String> names = new HashSet<>();
    private Optional<Frame> frame = Optional.empty();
    private double time = Double.NEGATIVE_INFINITY;
    private long times;
    private long leftOut;

    /**
     * For a world object.
     *
     * @param actuators what it can be told
     * @param each how many measured instants there are to each that is taken
     */
    RecordedRows(long id, List<String> actuators, long each) {
        this.id = id;
        this.actuators = actuators;
        this.each = each;
    }

    @Override
    public void sent(double at, Message message) {
        switch (message) {
            case FeedbackMessage feedback when feedback.worldObjectId() == id -> take(feedback);
            case SetPropulsorCommand set when set.worldObjectId() == id ->
                    tell(at, set.name(), set.level());
            case SetControlSurfaceCommand set when set.worldObjectId() == id ->
                    tell(at, set.name(), set.angle());
            default -> {
                // of no interest here
            }
        }
    }

    private void tell(double at, String name, double level) {
        names.add(name);
        int i = actuators.indexOf(name);
        if (i >= 0) {
            told.computeIfAbsent(at, _ -> nothing(actuators.size()))[i] = level;
        }
    }

    private static double[] nothing(int size) {
        double[] nothing = new double[size];
        Arrays.fill(nothing, Double.NaN);
        return nothing;
    }

    private void take(FeedbackMessage feedback) {
        if (feedback.timestamp() != time) {
            time = feedback.timestamp();
            times++;
        }
        if ((times - 1) % each == 0) {
            double[] row =
                    measured.computeIfAbsent(time, _ -> nothing(Slots.COMMANDS + actuators.size()));
            fill(feedback.measurement(), row);
        }
    }

    private void fill(Measurement m, double[] row) {
        boolean inBody = m.frame() == MeasurementFrame.BODY;
        Axes axes = m.frame() == MeasurementFrame.NED ? Axes.NED : Axes.ENU;
        Frame ofVelocity = inBody ? Frame.BODY : Frame.WORLD;
        boolean hasVelocity = m.velocity().isPresent() || m.angularVelocity().isPresent();
        if (hasVelocity && frame.isEmpty()) {
            frame = Optional.of(ofVelocity);
        }
        boolean keepsVelocity = frame.filter(ofVelocity::equals).isPresent();
        boolean isLeftOut =
                (hasVelocity && !keepsVelocity)
                        || (inBody && (m.position().isPresent() || m.orientation().isPresent()));
        leftOut += isLeftOut ? 1 : 0;
        if (!inBody) {
            m.position().ifPresent(p -> put(axes.world(p), row, Slots.POSITION));
            m.orientation().ifPresent(q -> put(axes.orientation(q), row));
        }
        if (keepsVelocity) {
            m.velocity().ifPresent(v -> put(axes.world(v), row, Slots.VELOCITY));
            m.angularVelocity().ifPresent(w -> put(axes.world(w), row, Slots.ANGULAR_VELOCITY));
        }
        fillDeviations(m, axes, row);
    }

    private static void put(Vec3 v, double[] row, int slot) {
        row[slot] = v.x();
        row[slot + 1] = v.y();
        row[slot + 2] = v.z();
    }

    private static void put(Quat q, double[] row) {
        row[Slots.QUATERNION] = q.w();
        row[Slots.QUATERNION + 1] = q.x();
        row[Slots.QUATERNION + 2] = q.y();
        row[Slots.QUATERNION + 3] = q.z();
    }

    /** The square roots of a covariance's diagonal. */
    private static void fillDeviations(Measurement m, Axes axes, double[] row) {
        if (m.covariance().isEmpty()) {
            return;
        }
        double[][] elements = m.covariance().get().elements();
        List<Optional<?>> parts =
                List.of(m.position(), m.orientation(), m.velocity(), m.angularVelocity());
        int first = 0;
        for (int i = 0; i < parts.size(); i++) {
            if (parts.get(i).isPresent()) {
                Vec3 stated =
                        new Vec3(
                                Math.sqrt(elements[first][first]),
                                Math.sqrt(elements[first + 1][first + 1]),
                                Math.sqrt(elements[first + 2][first + 2]));
                put(axes.sizes(stated), row, Slots.DEVIATIONS + 3 * i);
                first += 3;
            }
        }
    }

    /** Measured instants that were sent. */
    long times() {
        return times;
    }

    /** Measurements of which a part is in axes that cannot be used. */
    long leftOut() {
        return leftOut;
    }

    /** In which axes velocities are. */
    Frame frame() {
        return frame.orElse(Frame.WORLD);
    }

    /** What was measured, by time (s). */
    NavigableMap<Double, double[]> measured() {
        return measured;
    }

    /** Of all that was told anything, be it asked for or not. */
    Set<String> names() {
        return names;
    }

    /** What actuators were told, by time (s); NaN for those that were not. */
    NavigableMap<Double, double[]> told() {
        return told;
    }
}
