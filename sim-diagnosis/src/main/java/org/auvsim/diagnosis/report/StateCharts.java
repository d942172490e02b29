package org.auvsim.diagnosis.report;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.plot.page.Block;
import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Curve;
import org.auvsim.plot.page.Curve.Mark;
import org.auvsim.plot.page.Curve.Point;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * What a model misses of a run, over the state of the body: velocity, position and orientation, as
 * they are simulated, which has no noise.
 */
final class StateCharts {
    private static final int MOST_POINTS = 200;
    private static final String AXES = "xyz";

    private final MeasuredRun run;
    private final List<Abscissa> ways;
    private final List<Abscissa> turns;

    /**
     * Over the state of one motion.
     *
     * @param told sample by sample; no longer than the run
     */
    StateCharts(MeasuredRun run, List<RigidMotion> told) {
        this.run = run;
        this.ways = Abscissa.ofWays(told);
        this.turns = Abscissa.ofTurns(told);
    }

    /**
     * What is measured of a channel less what models tell, those of one part of the state beside
     * each other.
     *
     * @param models by their names, in order
     */
    List<Block> residuals(Channel channel, Map<String, Residuals> models) {
        boolean isTurn = channel == Channel.ORIENTATION || channel == Channel.ANGULAR_VELOCITY;
        List<Block> charts = new ArrayList<>();
        for (Abscissa over : isTurn ? turns : ways) {
            models.forEach((name, of) -> charts.add(residuals(channel, over, name, of)));
        }
        return charts;
    }

    private Chart residuals(Channel channel, Abscissa over, String model, Residuals residuals) {
        List<Curve> curves = new ArrayList<>();
        for (int axis = 0; axis < AXES.length(); axis++) {
            if (run.measures(channel, axis)) {
                List<Point> points = new ArrayList<>();
                for (int k = 0; k < residuals.size(); k++) {
                    double miss = residuals.of(channel, k).component(axis);
                    points.add(new Point(over.at(k, axis), miss));
                }
                curves.add(points(axis, points));
            }
        }
        return new Chart(
                "Residual of the %s over the %s, %s"
                        .formatted(channel.words(), over.title(), model),
                over.label(),
                "measured less simulated (%s)".formatted(channel.unit()),
                curves,
                "");
    }

    /**
     * The force that models lack.
     *
     * @param models by their names, in order
     * @param scale what all of these charts show at least
     */
    List<Block> forces(
            List<ForceResidual> forces,
            Map<String, Function<ForceResidual, Vec3>> models,
            List<Double> scale) {
        int[] samples = samples(forces);
        List<Block> charts = new ArrayList<>();
        for (Abscissa over : ways) {
            models.forEach(
                    (name, of) -> {
                        List<Vec3> missing = forces.stream().map(of).toList();
                        charts.add(forces(missing, samples, over, name).showing(scale));
                    });
        }
        return charts;
    }

    private static Chart forces(List<Vec3> missing, int[] samples, Abscissa over, String model) {
        List<Curve> curves = new ArrayList<>();
        for (int axis = 0; axis < AXES.length(); axis++) {
            List<Point> points = new ArrayList<>();
            for (int i = 0; i < samples.length; i++) {
                double force = missing.get(i).component(axis);
                points.add(new Point(over.at(samples[i], axis), force));
            }
            curves.add(points(axis, points));
        }
        return new Chart(
                "Missing force over the %s, %s".formatted(over.title(), model),
                over.label(),
                "force (N, world axes)",
                curves,
                "");
    }

    /** The last sample before each force, or at it. */
    private int[] samples(List<ForceResidual> forces) {
        return forces.stream().mapToInt(force -> run.sampleAt(force.time())).toArray();
    }

    private static Curve points(int axis, List<Point> points) {
        return new Curve(AXES.substring(axis, axis + 1), Mark.POINTS, points)
                .decimated(MOST_POINTS);
    }
}
