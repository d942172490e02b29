package org.auvsim.diagnosis.report;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.plot.page.Block;
import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Block.Text;
import org.auvsim.plot.page.Curve;
import org.auvsim.plot.page.Curve.Mark;
import org.auvsim.plot.page.Curve.Point;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Charts of one run: measured beside simulated, and what is left between them. */
final class RunCharts {
    private static final int MOST_POINTS = 500;

    /** A line may leave out this share of the numbers. */
    private static final double MOST_ALONE = 0.1;

    private static final String AXES = "xyz";
    private static final String TIME = "time (s)";
    private static final String SINCE_BEGIN = "time since the run began (s)";

    private static final String BEGIN_ALIKE =
            "Both models begin at the same start, that which suits the one with what was found.";

    private final MeasuredRun run;
    private final MeasuredRun counted;
    private final List<ForceResidual> forces;

    /** Whether times count from the run's beginning, as its clock's are too long to be read. */
    private final boolean isFar;

    private final Map<Channel, Double> noise;

    /** What the run is compared with: the model as believed and, if that differs, the other. */
    private final List<Model> models = new ArrayList<>();

    private record Model(String name, Mark mark, List<RigidMotion> told) {}

    /**
     * Charts of a run.
     *
     * @param names of the model as believed and, if that differs, the other one
     */
    RunCharts(DiagnosedRun of, Map<Channel, Double> noise, List<String> names) {
        this.run = of.run();
        this.counted = of.counted();
        this.forces = of.forces();
        this.isFar = run.beginsFar();
        this.noise = noise;
        boolean isOnly = names.size() == 1;
        models.add(new Model(names.getFirst(), isOnly ? Mark.LINE : Mark.DASHED, of.before()));
        if (!isOnly) {
            models.add(new Model(names.getLast(), Mark.LINE, of.after()));
        }
    }

    /** The path from above, or the one way along it that is measured, and the height. */
    List<Block> paths() {
        List<Block> blocks = new ArrayList<>();
        if (run.measures(Channel.POSITION, 0) && run.measures(Channel.POSITION, 1)) {
            blocks.add(fromAbove());
        } else {
            blocks.addAll(along(0, "Way along x over time"));
            blocks.addAll(along(1, "Way along y over time"));
        }
        blocks.addAll(along(2, "Height over time"));
        if (!blocks.isEmpty() && models.size() > 1) {
            blocks.addFirst(new Text(BEGIN_ALIKE));
        }
        return blocks;
    }

    /** Of an axis, if that is measured. */
    private List<Block> along(int axis, String title) {
        return run.measures(Channel.POSITION, axis)
                ? List.of(
                        overTime(
                                title,
                                AXES.charAt(axis) + " (m)",
                                k -> run.value(Channel.POSITION, k, axis),
                                motion -> motion.position().component(axis)))
                : List.of();
    }

    List<Block> all() {
        List<Block> blocks = new ArrayList<>(paths());
        blocks.addAll(speed());
        blocks.addAll(angles());
        boolean isSimulated = size(models.getLast()) == run.size();
        StateCharts overState =
                new StateCharts(run, isSimulated ? models.getLast().told() : List.of());
        for (Channel channel : Channel.values()) {
            if (run.measures(channel)) {
                models.forEach(model -> blocks.add(residuals(channel, model)));
                blocks.addAll(overState.residuals(channel, residuals()));
            }
        }
        if (!forces.isEmpty()) {
            blocks.addAll(forceResiduals(overState));
        }
        return blocks;
    }

    private Map<String, Residuals> residuals() {
        Map<String, Residuals> residuals = new LinkedHashMap<>();
        models.forEach(model -> residuals.put(model.name(), new Residuals(run, model.told())));
        return residuals;
    }

    private Chart fromAbove() {
        List<Curve> curves = new ArrayList<>();
        for (Model model : models) {
            curves.add(
                    curve(
                            model.name(),
                            model.mark(),
                            size(model),
                            k -> {
                                Vec3 p = model.told().get(k).position();
                                return new Point(p.x(), p.y());
                            }));
        }
        curves.add(
                curve(
                        "measured",
                        Mark.DOTS,
                        run.size(),
                        k ->
                                new Point(
                                        run.value(Channel.POSITION, k, 0),
                                        run.value(Channel.POSITION, k, 1))));
        return Chart.map("The path from above", "x (m)", "y (m)", curves, "");
    }

    private Chart overTime(
            String title,
            String unit,
            IntFunction<Double> measured,
            Function<RigidMotion, Double> told) {
        List<Curve> curves = new ArrayList<>();
        for (Model model : models) {
            curves.add(
                    curve(
                            model.name(),
                            model.mark(),
                            size(model),
                            k -> new Point(time(k), told.apply(model.told().get(k)))));
        }
        curves.add(
                curve(
                        "measured",
                        Mark.DOTS,
                        run.size(),
                        k -> new Point(time(k), measured.apply(k))));
        return new Chart(title, timeAxis(), unit, curves, "");
    }

    private List<Block> speed() {
        Speed speed = new Speed(run);
        return speed.isKnown()
                ? List.of(
                        overTime(
                                "Speed over time" + (speed.isMeasured() ? "" : ", by positions"),
                                "speed (m/s)",
                                speed::at,
                                motion -> motion.velocity().norm()))
                : List.of();
    }

    private List<Block> angles() {
        if (!run.measures(Channel.ORIENTATION)) {
            return List.of();
        }
        List<Block> charts = new ArrayList<>();
        for (Angle angle : Angle.values()) {
            if (run.measures(Channel.ORIENTATION, angle.axis())) {
                charts.add(angles(angle));
            }
        }
        return charts;
    }

    private Chart angles(Angle angle) {
        List<Curve> curves = new ArrayList<>();
        for (Model model : models) {
            curves.add(
                    curve(
                            model.name(),
                            model.mark(),
                            angle.course(size(model), k -> model.told().get(k).orientation())));
        }
        curves.add(
                curve(
                        "measured",
                        Mark.DOTS,
                        angle.measured(
                                run,
                                models.getLast().told().stream()
                                        .map(RigidMotion::orientation)
                                        .findFirst())));
        return new Chart(angle.words() + " over time", timeAxis(), "angle (rad)", curves, "");
    }

    private Curve curve(String name, Mark mark, double[] values) {
        return curve(name, mark, values.length, k -> new Point(time(k), values[k]));
    }

    private Chart residuals(Channel channel, Model model) {
        Residuals residuals = new Residuals(run, model.told());
        List<Curve> curves = new ArrayList<>();
        for (int axis = 0; axis < AXES.length(); axis++) {
            int of = axis;
            if (run.measures(channel, axis)) {
                curves.add(
                        curve(
                                AXES.substring(axis, axis + 1),
                                isSparse(channel, axis) ? Mark.POINTS : Mark.LINE,
                                residuals.size(),
                                k -> new Point(time(k), residuals.of(channel, k).component(of))));
            }
        }
        String unit = channel.unit();
        return new Chart(
                "Residual of the %s, %s".formatted(channel.words(), model.name()),
                timeAxis(),
                "measured less simulated (%s)".formatted(unit),
                curves,
                "Root mean square %s %s; noise %s %s."
                        .formatted(
                                Numbers.rounded(
                                        new Residuals(counted, model.told())
                                                .rootMeanSquare(channel)),
                                unit,
                                Numbers.rounded(noise.getOrDefault(channel, Double.NaN)),
                                unit));
    }

    /**
     * Whether many numbers stand alone between rows without one: a line would show none of them.
     */
    private boolean isSparse(Channel channel, int axis) {
        int numbers = 0;
        int alone = 0;
        for (int k = 0; k < run.size(); k++) {
            if (isMeasured(channel, k, axis)) {
                boolean isAlone =
                        !isMeasured(channel, k - 1, axis) && !isMeasured(channel, k + 1, axis);
                numbers++;
                alone += isAlone ? 1 : 0;
            }
        }
        return alone > MOST_ALONE * numbers;
    }

    private boolean isMeasured(Channel channel, int sample, int axis) {
        return sample >= 0
                && sample < run.size()
                && !Double.isNaN(run.value(channel, sample, axis));
    }

    /** On one scale: what is left is as small as it looks. */
    private List<Block> forceResiduals(StateCharts overState) {
        Map<String, Function<ForceResidual, Vec3>> missing = new LinkedHashMap<>();
        missing.put(models.getFirst().name(), ForceResidual::before);
        if (models.size() > 1) {
            missing.put(models.getLast().name(), ForceResidual::after);
        }
        List<Block> charts = new ArrayList<>();
        missing.forEach((model, of) -> charts.add(forceResidual(model, of)));
        charts.addAll(overState.forces(forces, missing, forces()));
        return charts;
    }

    private Chart forceResidual(String model, Function<ForceResidual, Vec3> of) {
        double[] travelled = new Travelled(run, models.getLast().told()).at(forces);
        List<Curve> curves = new ArrayList<>();
        for (int axis = 0; axis < AXES.length(); axis++) {
            int along = axis;
            curves.add(
                    curve(
                            AXES.substring(axis, axis + 1),
                            Mark.LINE,
                            forces.size(),
                            i ->
                                    new Point(
                                            travelled[i],
                                            of.apply(forces.get(i)).component(along))));
        }
        return new Chart(
                        "Missing force, " + model,
                        "distance travelled (m)",
                        "force (N, world axes)",
                        curves,
                        "At most %s N.".formatted(Numbers.rounded(most(of))))
                .showing(forces());
    }

    private double most(Function<ForceResidual, Vec3> of) {
        return forces.stream()
                .mapToDouble(force -> of.apply(force).norm())
                .filter(Double::isFinite)
                .max()
                .orElse(Double.NaN);
    }

    /** The least and the greatest component of the forces that the models lack. */
    private List<Double> forces() {
        Stream<Vec3> after =
                models.size() > 1 ? forces.stream().map(ForceResidual::after) : Stream.of();
        double[] all =
                Stream.concat(forces.stream().map(ForceResidual::before), after)
                        .flatMapToDouble(force -> DoubleStream.of(force.x(), force.y(), force.z()))
                        .filter(Double::isFinite)
                        .toArray();
        return all.length == 0
                ? List.of()
                : List.of(
                        DoubleStream.of(all).min().orElseThrow(),
                        DoubleStream.of(all).max().orElseThrow());
    }

    private double time(int sample) {
        return isFar ? run.time(sample) - run.time(0) : run.time(sample);
    }

    private String timeAxis() {
        return isFar ? SINCE_BEGIN : TIME;
    }

    private int size(Model model) {
        return Math.min(run.size(), model.told().size());
    }

    private static Curve curve(String name, Mark mark, int size, IntFunction<Point> points) {
        return new Curve(name, mark, IntStream.range(0, size).mapToObj(points).toList())
                .decimated(MOST_POINTS);
    }
}
