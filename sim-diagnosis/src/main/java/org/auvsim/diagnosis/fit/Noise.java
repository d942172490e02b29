package org.auvsim.diagnosis.fit;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * How much noise a measurement has, from the measurement alone: third differences of positions, and
 * second differences of increments of rotation, hardly contain motion. Both have the variance of
 * the noise times 20 (1, 3, 3, 1 squared); the median absolute deviation is not misled by outliers.
 */
final class Noise {
    /** Of a normal distribution: the median absolute deviation in standard deviations. */
    private static final double NORMAL = 0.6745;

    private Noise() {}

    /** The noise of runs that were measured with the same sensors. */
    static Weights of(List<MeasuredRun> runs) {
        List<Double> positions = new ArrayList<>();
        List<Double> rotations = new ArrayList<>();
        for (MeasuredRun run : runs) {
            for (int k = 3; k < run.size(); k++) {
                positionDifferences(run, k, positions);
                rotationDifferences(run, k, rotations);
            }
        }
        return new Weights(deviation(positions), deviation(rotations));
    }

    private static void positionDifferences(MeasuredRun run, int k, List<Double> to) {
        Vec3[] p = new Vec3[4];
        for (int i = 0; i < 4; i++) {
            Optional<Vec3> measured = run.samples().get(k - 3 + i).position();
            if (measured.isEmpty()) {
                return;
            }
            p[i] = measured.get();
        }
        Vec3 third = p[3].minus(p[2].times(3)).plus(p[1].times(3)).minus(p[0]);
        to.addAll(List.of(third.x(), third.y(), third.z()));
    }

    private static void rotationDifferences(MeasuredRun run, int k, List<Double> to) {
        Vec3[] turns = new Vec3[3];
        for (int i = 0; i < 3; i++) {
            Optional<Quat> before = run.samples().get(k - 3 + i).orientation();
            Optional<Quat> after = run.samples().get(k - 2 + i).orientation();
            if (before.isEmpty() || after.isEmpty()) {
                return;
            }
            turns[i] = turn(before.get(), after.get());
        }
        Vec3 second = turns[2].minus(turns[1].times(2)).plus(turns[0]);
        to.addAll(List.of(second.x(), second.y(), second.z()));
    }

    private static Vec3 turn(Quat from, Quat to) {
        double[] difference = at(to).minus(at(from));
        return new Vec3(difference[3], difference[4], difference[5]);
    }

    private static RigidMotion at(Quat orientation) {
        return new RigidMotion(Vec3.ZERO, orientation, Vec3.ZERO, Vec3.ZERO);
    }

    private static double deviation(List<Double> differences) {
        if (differences.isEmpty()) {
            return 1; // nothing was measured: nothing is weighed
        }
        double[] sizes = differences.stream().mapToDouble(Math::abs).sorted().toArray();
        double median = sizes[sizes.length / 2];
        return Math.max(median / NORMAL / Math.sqrt(20), smallest(Arrays.copyOf(sizes, sizes.length)));
    }

    /** Numbers in a file are rounded: noise below that cannot be told. */
    private static double smallest(double[] sizes) {
        return Math.max(1e-9, 1e-9 * sizes[sizes.length - 1]);
    }
}
