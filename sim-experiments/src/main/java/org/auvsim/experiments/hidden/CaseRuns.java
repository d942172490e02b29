package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * The runs of a case.
 *
 * @param measured with noise
 * @param truth without
 */
record CaseRuns(List<MeasuredRun> measured, List<List<Pose>> truth) {
    /** So many runs are to fit; the others are held out. */
    static final int FIT = 3;

    /** How well starts of held-out runs are known against those of fit runs. */
    private static final double WELL_KNOWN = 1e-3;

    private static final double START_TURNED = 0.02;
    private static final double START_TURNING = 0.05;

    /**
     * Makes and measures the runs with what is hidden.
     *
     * @param looseness factor by which velocities at the start are less known than usual
     * @return empty if they cannot be followed
     */
    static Optional<CaseRuns> measured(
            Scene scene,
            Trial believed,
            List<HiddenEffect> hidden,
            double noise,
            boolean isHeavyTailed,
            double looseness,
            Draws draws) {
        Reality reality = Reality.of(scene.plant());
        for (HiddenEffect effect : hidden) {
            reality = effect.change().apply(reality);
        }
        List<Manoeuvre> done = new ArrayList<>();
        List<KnownStart> starts = new ArrayList<>();
        for (int r = 0; r < believed.manoeuvres().size(); r++) {
            Manoeuvre stated = believed.manoeuvres().get(r);
            Start start = new Start(scene, r < FIT ? 1 : WELL_KNOWN, looseness);
            done.add(stated.from(start.drawn(stated.start(), draws)));
            starts.add(start.known(stated.start()));
        }
        Measurement measurement =
                new Measurement(
                        noise * scene.range(),
                        scene.shows() ? noise * scene.turns() : 0,
                        isHeavyTailed);
        return new Trial(done, believed.seeds())
                .poses(reality)
                .map(
                        poses -> {
                            List<MeasuredRun> runs = new ArrayList<>();
                            for (int r = 0; r < poses.size(); r++) {
                                runs.add(
                                        measurement.of(
                                                (r < FIT ? "fit " : "held out ") + (r + 1),
                                                poses.get(r),
                                                done.get(r),
                                                starts.get(r),
                                                draws));
                            }
                            return new CaseRuns(runs, poses);
                        });
    }

    /** How uncertain a start is. */
    private record Start(Scene scene, double factor, double looseness) {
        private double away() {
            return factor * 0.01 * scene.range();
        }

        private double faster() {
            return factor * looseness * 0.05 * scene.speed();
        }

        Instant drawn(Instant stated, Draws draws) {
            Attitude attitude =
                    Attitude.turned(draws.normals(factor * START_TURNED)).after(stated.attitude());
            // Stated in world axes, so that it is not off by the attitude's error as well.
            Vector3D turning = stated.turningInWorld().add(draws.normals(factor * START_TURNING));
            return new Instant(
                    0,
                    stated.position().add(draws.normals(away())),
                    attitude,
                    stated.velocity().add(draws.normals(faster())),
                    attitude.toBody(turning),
                    Vector3D.ZERO);
        }

        KnownStart known(Instant stated) {
            List<Double> deviations = new ArrayList<>();
            for (double deviation :
                    new double[] {
                        away(), factor * START_TURNED, faster(), factor * START_TURNING
                    }) {
                deviations.addAll(Collections.nCopies(3, deviation));
            }
            return new KnownStart(Measurement.motion(stated), deviations);
        }
    }
}
