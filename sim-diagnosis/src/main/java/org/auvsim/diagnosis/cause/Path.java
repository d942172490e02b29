package org.auvsim.diagnosis.cause;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * Where bodies went in runs.
 *
 * @param places some of them, spread over all runs (m, world)
 * @param low corner of the box around them (m, world)
 * @param high the corner across
 * @param speed typical (m/s)
 * @param begin of the first run (s)
 * @param end of the last run (s)
 * @param duration of the longest run (s)
 * @param spans in which there were any, in order, none into another
 */
record Path(
        List<Vec3> places,
        Vec3 low,
        Vec3 high,
        double speed,
        double begin,
        double end,
        double duration,
        List<Span> spans) {
    private static final int LOOKS = 200;
    private static final double SLOWEST = 1e-3;
    private static final double SHORTEST = 1e-2;

    private static final List<Vec3> AXES =
            List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    /** That of a body; what is not measured of where it is may be known from what holds it. */
    static Path of(List<MeasuredRun> runs, WorldObjectDefinition body) {
        List<Vec3> places = new ArrayList<>();
        double[] speeds = new double[2];
        for (MeasuredRun run : runs) {
            walk(run, body, places, speeds);
        }
        double begin = runs.stream().mapToDouble(run -> run.time(0)).min().orElseThrow();
        double end = runs.stream().mapToDouble(r -> r.time(0) + r.duration()).max().orElseThrow();
        double duration = runs.stream().mapToDouble(MeasuredRun::duration).max().orElseThrow();
        double speed = speeds[1] == 0 ? 0 : Math.sqrt(speeds[0] / speeds[1]);
        return new Path(
                List.copyOf(places),
                corner(places, Double.POSITIVE_INFINITY, Math::min),
                corner(places, Double.NEGATIVE_INFINITY, Math::max),
                Math.max(SLOWEST, speed),
                begin,
                end,
                duration,
                spans(runs));
    }

    /** From a time until another (s). */
    record Span(double from, double until) {}

    private static List<Span> spans(List<MeasuredRun> runs) {
        List<Span> spans = new ArrayList<>();
        runs.stream()
                .map(run -> new Span(run.time(0), run.time(0) + run.duration()))
                .sorted(Comparator.comparingDouble(Span::from))
                .forEach(
                        span -> {
                            Span last = spans.isEmpty() ? span : spans.removeLast();
                            if (span.from() > last.until()) {
                                spans.add(last);
                                spans.add(span);
                            } else {
                                spans.add(
                                        new Span(
                                                last.from(), Math.max(last.until(), span.until())));
                            }
                        });
        return List.copyOf(spans);
    }

    /** Sums squares of speeds, and counts them: over long ways, as noise hides short ones. */
    private static void walk(
            MeasuredRun run, WorldObjectDefinition body, List<Vec3> places, double[] speeds) {
        int stride = Math.max(1, run.size() / LOOKS);
        for (int k = 0; k < run.size(); k += stride) {
            IntStream.range(k, Math.min(run.size(), k + stride))
                    .mapToObj(i -> place(run, i, body))
                    .flatMap(Optional::stream)
                    .findFirst()
                    .ifPresent(places::add);
            double speed = speed(run, k, Math.min(run.size() - 1, k + 5 * stride));
            if (Double.isFinite(speed)) {
                speeds[0] += speed * speed;
                speeds[1]++;
            }
        }
    }

    private static Optional<Vec3> place(MeasuredRun run, int k, WorldObjectDefinition body) {
        double[] place = new double[3];
        boolean isMeasured = false;
        for (int axis = 0; axis < 3; axis++) {
            place[axis] = run.value(Channel.POSITION, k, axis);
            isMeasured |= !Double.isNaN(place[axis]);
            if (Double.isNaN(place[axis]) && !Setting.goes(body, AXES.get(axis))) {
                place[axis] = body.position().dot(AXES.get(axis));
            }
        }
        Vec3 at = new Vec3(place[0], place[1], place[2]);
        return isMeasured && Double.isFinite(at.norm()) ? Optional.of(at) : Optional.empty();
    }

    private static double speed(MeasuredRun run, int from, int to) {
        if (run.measures(Channel.VELOCITY)) {
            return IntStream.rangeClosed(from, to)
                    .mapToDouble(k -> run.norm(Channel.VELOCITY, k))
                    .filter(Double::isFinite)
                    .findFirst()
                    .orElse(Double.NaN);
        }
        double square = Double.NaN;
        for (int axis = 0; axis < 3; axis++) {
            double along = along(run, axis, from, to);
            if (!Double.isNaN(along)) {
                square = (Double.isNaN(square) ? 0 : square) + along * along;
            }
        }
        return Math.sqrt(square);
    }

    /** From the first number that was measured from a sample on to that from another one on. */
    private static double along(MeasuredRun run, int axis, int from, int to) {
        int first = measured(run, axis, from);
        int last = measured(run, axis, to);
        return first < last && last < run.size()
                ? (run.value(Channel.POSITION, last, axis)
                                - run.value(Channel.POSITION, first, axis))
                        / (run.time(last) - run.time(first))
                : Double.NaN;
    }

    private static int measured(MeasuredRun run, int axis, int from) {
        int k = from;
        while (k < run.size() && Double.isNaN(run.value(Channel.POSITION, k, axis))) {
            k++;
        }
        return k;
    }

    private interface Choice {
        double of(double a, double b);
    }

    private static Vec3 corner(List<Vec3> places, double from, Choice choice) {
        Vec3 corner = new Vec3(from, from, from);
        for (Vec3 p : places) {
            corner =
                    new Vec3(
                            choice.of(corner.x(), p.x()),
                            choice.of(corner.y(), p.y()),
                            choice.of(corner.z(), p.z()));
        }
        return places.isEmpty() ? Vec3.ZERO : corner;
    }

    /** The middle of the box around it (m). */
    Vec3 centre() {
        return low.plus(high).times(0.5);
    }

    /** The longest side of that box (m), or what the speed makes of the duration. */
    double range() {
        Vec3 size = high.minus(low);
        double longest = Math.max(size.x(), Math.max(size.y(), size.z()));
        return Math.max(SHORTEST, places.isEmpty() ? speed * duration : longest);
    }

    /** Half the diagonal of that box (m). */
    double radius() {
        return Math.max(SHORTEST, high.minus(low).norm() / 2);
    }

    /** The mean of something over its places; where there are none, that at its middle. */
    double mean(ToDoubleFunction<Vec3> of) {
        return places.stream()
                .mapToDouble(of)
                .average()
                .orElseGet(() -> of.applyAsDouble(centre()));
    }

    /** The distance from a point that a share of the places is nearer than (m). */
    double quantile(Vec3 from, double share) {
        double[] distances = places.stream().mapToDouble(from::distance).sorted().toArray();
        return distances[(int) Math.min(distances.length - 1, share * distances.length)];
    }

    /** For how long there were runs (s). */
    double total() {
        return spans.stream().mapToDouble(span -> span.until() - span.from()).sum();
    }

    /** Times at which there were runs, spread evenly (s). */
    double[] times(int count) {
        double all = total();
        double[] times = new double[count];
        Arrays.setAll(times, i -> after(all * (i + 0.5) / count));
        return times;
    }

    /** The time until which there were runs for so long (s). */
    private double after(double duration) {
        double left = duration;
        for (Span span : spans) {
            double length = span.until() - span.from();
            if (left <= length) {
                return span.from() + left;
            }
            left -= length;
        }
        return end;
    }
}
