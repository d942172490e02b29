package org.auvsim.diagnosis.cause;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.IntStream;

/** Measurements that tell otherwise than the body moves. */
final class SensorCauses {
    private static final int YAW = 2;
    private static final List<String> AXES = List.of("x", "y", "z");
    private static final double LONGEST_DELAY = 5;

    private SensorCauses() {}

    static List<Cause> of(Setting s) {
        List<Cause> causes = new ArrayList<>();
        if (yaws(s.model()) && s.runs().stream().anyMatch(SensorCauses::measuresYaw)) {
            causes.add(
                    Change.of(
                            "sensor_bias",
                            List.of(new Parameter("yaw", "rad", 0.02, -Math.PI, Math.PI)),
                            (v, t) -> v.sensed(sensing -> sensing.yawed(t[0], 0))));
            double perSecond = 0.02 / longest(s);
            causes.add(
                    Change.of(
                            "sensor_drift",
                            List.of(Parameter.signed("yaw_rate", "rad/s", perSecond)),
                            (v, t) -> v.sensed(sensing -> sensing.yawed(0, t[0]))));
            causes.add(
                    Change.of(
                                    "compass_deviation",
                                    List.of(
                                            new Parameter("sine", "rad", 0.02, -1, 1),
                                            new Parameter("cosine", "rad", 0.02, -1, 1)),
                                    (v, t) -> v.sensed(sensing -> sensing.besideIron(t[0], t[1])))
                            .asGeneric());
        }
        causes.add(
                Change.of(
                                "sensor_delay",
                                List.of(new Parameter("delay", "s", 0.05, 0, LONGEST_DELAY)),
                                (v, t) -> v.sensed(sensing -> sensing.delayed(t[0])))
                        .from(List.of(Change.secant(0.05), Change.secant(0.3))));
        causes.add(
                Change.of(
                                "clock_offset",
                                List.of(
                                        new Parameter(
                                                "offset",
                                                "s",
                                                0.05,
                                                -LONGEST_DELAY,
                                                LONGEST_DELAY)),
                                (v, t) -> v.sensed(sensing -> sensing.delayed(t[0])))
                        .asGeneric());
        if (isMeasuredBesideOthers(Channel.ORIENTATION, s) && turns(s.model())) {
            causes.add(delay("orientation_delay", Sensing::withLateOrientations));
        }
        if (isMeasuredBesideOthers(Channel.POSITION, s)) {
            causes.add(delay("position_delay", Sensing::withLatePositions));
        }
        if (s.measures(Channel.POSITION)) {
            causes.addAll(ofPositions(s));
            if (s.measures(Channel.ORIENTATION) && turns(s.model())) {
                causes.add(leverArm(s));
            }
        }
        int[] placed = placedAxes(s);
        if (placed.length > 0) {
            causes.add(offset(placed, s));
        }
        return causes;
    }

    /**
     * The axes along which positions were measured of a body whose place was known at the start.
     */
    private static int[] placedAxes(Setting s) {
        return IntStream.range(0, AXES.size())
                .filter(axis -> s.runs().stream().anyMatch(run -> isPlaced(run, axis)))
                .toArray();
    }

    private static boolean isPlaced(MeasuredRun run, int axis) {
        return run.measures(Channel.POSITION, axis)
                && run.start().filter(at -> Double.isFinite(at.deviations().get(axis))).isPresent();
    }

    /** Elsewhere than at a known start it cannot be told from where the body is. */
    private static Cause offset(int[] axes, Setting s) {
        return Change.of(
                "sensor_offset",
                Arrays.stream(axes)
                        .mapToObj(
                                axis ->
                                        Parameter.signed(
                                                "offset." + AXES.get(axis),
                                                "m",
                                                0.05 * s.path().range()))
                        .toList(),
                (v, t) -> v.sensed(sensing -> sensing.shifted(vector(axes, t))));
    }

    private static Vec3 vector(int[] axes, double[] along) {
        double[] all = new double[AXES.size()];
        for (int i = 0; i < axes.length; i++) {
            all[axes[i]] = along[i];
        }
        return new Vec3(all[0], all[1], all[2]);
    }

    private static boolean isMeasuredBesideOthers(Channel channel, Setting s) {
        return s.measures(channel)
                && Arrays.stream(Channel.values()).anyMatch(c -> c != channel && s.measures(c));
    }

    /** Of what one sensor tells; where nothing else is measured it is that of all there is. */
    private static Cause delay(String id, BiFunction<Sensing, Double, Sensing> late) {
        return Change.of(
                        id,
                        List.of(new Parameter("delay", "s", 0.05, 0, LONGEST_DELAY)),
                        (v, t) -> v.sensed(sensing -> late.apply(sensing, t[0])))
                .from(List.of(Change.secant(0.05), Change.secant(0.3)))
                .asGeneric();
    }

    /** Of a body that does not turn it cannot be told from where the body is. */
    private static Cause leverArm(Setting s) {
        return Change.of(
                        "sensor_lever_arm",
                        Parameter.vector("arm", "m", 0.02 * s.path().range()),
                        (v, t) -> v.sensed(sensing -> sensing.armed(new Vec3(t[0], t[1], t[2]))))
                .asGeneric();
    }

    private static boolean turns(BelievedModel model) {
        double[] turn = new double[RigidMotion.SIZE];
        Arrays.fill(turn, 3, 6, 1);
        return Arrays.stream(model.free(turn), 3, 6).anyMatch(about -> about != 0);
    }

    /** A heading that cannot change tells nothing of its sensor. */
    private static boolean yaws(BelievedModel model) {
        double[] turn = new double[RigidMotion.SIZE];
        turn[3 + YAW] = 1;
        return model.free(turn)[3 + YAW] != 0;
    }

    private static boolean measuresYaw(MeasuredRun run) {
        return run.measures(Channel.ORIENTATION, YAW);
    }

    /** For how long drifts have grown at most (s): in parts, too, from the run's beginning on. */
    private static double longest(Setting s) {
        return s.runs().stream()
                .mapToDouble(run -> run.time(run.size() - 1) - run.whole().time(0))
                .max()
                .orElseThrow();
    }

    private static List<Cause> ofPositions(Setting s) {
        double perSecond = 0.05 * s.path().range() / longest(s);
        return List.of(
                Change.of(
                        "axis_misalignment",
                        Parameter.vector("turn", "rad", 0.02),
                        (v, t) -> v.sensed(sensing -> sensing.turned(new Vec3(t[0], t[1], t[2])))),
                Change.of(
                                "sensor_scale",
                                List.of(
                                        new Parameter("scale.x", "1", 0.02, -0.9, 9),
                                        new Parameter("scale.y", "1", 0.02, -0.9, 9),
                                        new Parameter("scale.z", "1", 0.02, -0.9, 9)),
                                (v, t) ->
                                        v.sensed(
                                                sensing ->
                                                        sensing.scaled(new Vec3(t[0], t[1], t[2]))))
                        .toldAsFactors()
                        .asGeneric(),
                Change.of(
                                "position_drift",
                                Parameter.vector("rate", "m/s", perSecond),
                                (v, t) ->
                                        v.sensed(
                                                sensing ->
                                                        sensing.drifting(
                                                                new Vec3(t[0], t[1], t[2]))))
                        .asGeneric());
    }
}
