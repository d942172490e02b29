package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Axes;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.EulerAngles;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;

import java.util.List;
import java.util.Map;

/** Turns the numbers of rows into samples of a run, in the simulator's axes. */
final class RowSample {
    private final Axes axes;
    private final Frame velocity;
    private final Frame angularVelocity;
    private final Frame orientation;
    private final Vec3 usualAngles;
    private final Map<Integer, List<LastingError>> lasting;

    /**
     * For rows in axes.
     *
     * @param velocity the frame of velocities
     * @param angularVelocity that of angular velocities
     * @param orientation that of angles: the body's, where roll or pitch is measured without the
     *     other, whatever it heads for
     * @param usual the orientation (body to world) whose angles stand in for those that are not
     *     measured
     * @param lasting errors that last, by the place in a row of what they are of
     */
    RowSample(
            Axes axes,
            Frame velocity,
            Frame angularVelocity,
            Frame orientation,
            Quat usual,
            Map<Integer, List<LastingError>> lasting) {
        this.axes = axes;
        this.velocity = velocity;
        this.angularVelocity = angularVelocity;
        this.orientation = orientation;
        this.usualAngles = EulerAngles.of(axes.orientation(usual));
        this.lasting = lasting;
    }

    /** Says what the samples' axes are, and which errors last. */
    void tell(MeasuredRunBuilder run) {
        run.frame(Channel.VELOCITY, velocity)
                .frame(Channel.ANGULAR_VELOCITY, angularVelocity)
                .frame(Channel.ORIENTATION, orientation);
        for (Channel channel : Channel.values()) {
            for (int column = 0; column < 3; column++) {
                boolean isSwapped = axes == Axes.NED && column < 2 && !isInBody(channel);
                for (LastingError error : lasting(Slots.measuredBy(channel) + column)) {
                    run.lastingError(channel, isSwapped ? 1 - column : column, error);
                }
            }
        }
        for (LastingError ofQuaternion : lasting(Slots.QUATERNION)) {
            for (int axis = 0; axis < 3; axis++) {
                run.lastingError(Channel.ORIENTATION, axis, ofQuaternion.times(2));
            }
        }
    }

    private List<LastingError> lasting(int slot) {
        return lasting.getOrDefault(slot, List.of());
    }

    /** What was measured in a row. */
    void addMeasured(double[] row, MeasuredRunBuilder to) {
        Vec3 position = axes.world(vector(row, Slots.POSITION));
        to.position(position.x(), position.y(), position.z());
        to.shaking(row[Slots.SHAKING], row[Slots.SHAKING + 1]);
        addOrientation(row, to);
        add(Channel.VELOCITY, velocity, vector(row, Slots.VELOCITY), to);
        add(Channel.ANGULAR_VELOCITY, angularVelocity, vector(row, Slots.ANGULAR_VELOCITY), to);
        for (Channel channel : Channel.values()) {
            Vec3 stated = vector(row, Slots.deviation(channel));
            Vec3 size = isInBody(channel) ? stated : axes.sizes(stated);
            to.deviation(channel, size.x(), size.y(), size.z());
        }
    }

    private boolean isInBody(Channel channel) {
        return (channel == Channel.VELOCITY && velocity == Frame.BODY)
                || (channel == Channel.ANGULAR_VELOCITY && angularVelocity == Frame.BODY)
                || (channel == Channel.ORIENTATION && orientation == Frame.BODY);
    }

    private void add(Channel channel, Frame frame, Vec3 measured, MeasuredRunBuilder to) {
        Vec3 v = frame == Frame.BODY ? axes.body(measured) : axes.world(measured);
        to.measured(channel, v.x(), v.y(), v.z());
    }

    private void addOrientation(double[] row, MeasuredRunBuilder to) {
        if (!Double.isNaN(row[Slots.QUATERNION])) {
            Quat q =
                    new Quat(
                            row[Slots.QUATERNION],
                            row[Slots.QUATERNION + 1],
                            row[Slots.QUATERNION + 2],
                            row[Slots.QUATERNION + 3]);
            to.orientation(axes.orientation(q.normalized()));
            return;
        }
        Vec3 angles = vector(row, Slots.ANGLES);
        boolean roll = !Double.isNaN(angles.x());
        boolean pitch = !Double.isNaN(angles.y());
        boolean yaw = !Double.isNaN(angles.z());
        if (roll || pitch || yaw) {
            Quat q =
                    EulerAngles.orientation(
                            roll ? angles.x() : usualAngles.x(),
                            pitch ? angles.y() : usualAngles.y(),
                            yaw ? angles.z() : usualAngles.z());
            boolean isSwapped = axes == Axes.NED && !isInBody(Channel.ORIENTATION);
            boolean x = isSwapped ? pitch : roll;
            boolean y = isSwapped ? roll : pitch;
            to.orientation(axes.orientation(q), x, y, yaw);
        }
    }

    private static Vec3 vector(double[] row, int slot) {
        return new Vec3(row[slot], row[slot + 1], row[slot + 2]);
    }
}
