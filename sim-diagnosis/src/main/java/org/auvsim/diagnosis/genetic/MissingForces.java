package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.genetic.Formula.Sample;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.EulerAngles;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** The forces that a model lacks along a run, beside what was measured there. */
final class MissingForces {
    /** So many samples before and after tell the velocity. */
    private static final int NEAR = 3;

    private MissingForces() {}

    /** Along an axis of the world, where position was measured. */
    static List<Sample> along(DiagnosedRun of, int axis) {
        List<Sample> samples = new ArrayList<>();
        for (ForceResidual residual : of.forces()) {
            int at = of.run().sampleAt(residual.time());
            Optional<Vec3> position = of.run().vector(Channel.POSITION, at);
            double force = residual.before().component(axis);
            if (position.isPresent() && Double.isFinite(force)) {
                samples.add(new Sample(variables(of.run(), at, position.get()), force));
            }
        }
        return samples;
    }

    private static double[] variables(MeasuredRun run, int at, Vec3 position) {
        Vec3 angles = angles(run, at);
        return new double[] {
            run.time(at),
            position.x(),
            position.y(),
            position.z(),
            velocity(run, at, 0),
            velocity(run, at, 1),
            velocity(run, at, 2),
            angles.x(),
            angles.y(),
            angles.z()
        };
    }

    /** Those that were measured nearest to a sample; 0 if none ever were. */
    private static Vec3 angles(MeasuredRun run, int at) {
        return IntStream.range(0, run.size())
                .flatMap(away -> IntStream.of(at - away, at + away))
                .filter(k -> k >= 0 && k < run.size() && run.isOriented(k))
                .mapToObj(run::orientation)
                .flatMap(Optional::stream)
                .findFirst()
                .map(EulerAngles::of)
                .orElse(Vec3.ZERO);
    }

    /** The slope of the positions around a sample. */
    private static double velocity(MeasuredRun run, int at, int axis) {
        SimpleRegression line = new SimpleRegression();
        for (int k = Math.max(0, at - NEAR); k <= Math.min(run.size() - 1, at + NEAR); k++) {
            double value = run.value(Channel.POSITION, k, axis);
            if (!Double.isNaN(value)) {
                line.addData(run.time(k), value);
            }
        }
        double slope = line.getSlope();
        return Double.isNaN(slope) ? 0 : slope;
    }
}
