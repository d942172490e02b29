package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** Whether the numbers of a run can be what they are taken for. */
final class Plausibility {
    /** Rates about an axis (rad/s) that differ by more are suspicious. */
    private static final double SEVERAL_TURNS = 20;

    private final BelievedModel model;
    private final MeasuredRun run;

    private final Source source;
    private final boolean inDegrees;

    /** Turns by less (rad) are those of rounded angles. */
    private static final double STILL = 1e-6;

    /**
     * That of a run.
     *
     * @param inDegrees whether its angles and rates were read as degrees
     */
    Plausibility(BelievedModel model, MeasuredRun run, Source source, boolean inDegrees) {
        this.model = model;
        this.run = run;
        this.source = source;
        this.inDegrees = inDegrees;
    }

    /**
     * What looks wrong but may be right.
     *
     * @throws DocumentException if nothing moves at all
     */
    List<String> notices() throws DocumentException {
        if (isEmpty()) {
            throw new DocumentException(
                    source.says(
                            source.measured(),
                            "run '%s' has no measured number in any row; expected some: leave the run out, or look at what wrote it"
                                    .formatted(run.name())));
        }
        if (isConstant()) {
            throw new DocumentException(
                    source.says(
                            source.measured(),
                            "every measured number of run '%s' is the same from its first row to its last; nothing can be learnt from it: leave it out, or look at what wrote it"
                                    .formatted(run.name())));
        }
        List<String> notices = new ArrayList<>();
        velocity().ifPresentOrElse(notices::add, () -> notices.addAll(velocities()));
        way().ifPresent(notices::add);
        new Jump(run, source).notice().ifPresent(notices::add);
        return notices;
    }

    private boolean isEmpty() {
        return Arrays.stream(Channel.values()).noneMatch(run::measures);
    }

    private boolean isConstant() {
        for (Channel channel : Channel.values()) {
            for (int axis = 0; axis < 3; axis++) {
                if (channel != Channel.ORIENTATION && run.range(channel, axis) > 0) {
                    return false;
                }
            }
        }
        return largestTurn() < STILL;
    }

    private double largestTurn() {
        Optional<Quat> first = Optional.empty();
        double largest = 0;
        for (int k = 0; k < run.size(); k++) {
            Optional<Quat> now = run.orientation(k);
            first = first.or(() -> now);
            if (now.isPresent()) {
                Quat turn = first.get().conjugate().times(now.get());
                largest = Math.max(largest, new Vec3(turn.x(), turn.y(), turn.z()).norm());
            }
        }
        return largest;
    }

    private Optional<String> velocity() {
        return new VelocityUnits(run)
                .suspicion()
                .map(
                        seen -> {
                            List<String> columns = new ArrayList<>(positions(seen.axes()));
                            columns.addAll(velocities(seen.axes()));
                            return source.says(
                                    columns,
                                    "positions go %s times as far as velocities say: is one of them in another unit?"
                                            .formatted(Figures.shown(seen.ratio(), 2)));
                        });
    }

    private List<String> velocities() {
        return new VelocityFactors(run)
                .suspicions().stream()
                        .collect(
                                Collectors.groupingBy(
                                        VelocityFactors.Suspicion::what,
                                        LinkedHashMap::new,
                                        Collectors.mapping(
                                                seen ->
                                                        source.column(
                                                                run, Channel.VELOCITY, seen.axis()),
                                                Collectors.toList())))
                        .entrySet()
                        .stream()
                        .map(seen -> source.says(seen.getValue(), seen.getKey()))
                        .toList();
    }

    private List<String> positions(List<Integer> axes) {
        return axes.stream().map(axis -> source.column(Channel.POSITION, axis)).toList();
    }

    private List<String> velocities(List<Integer> axes) {
        return run.frame(Channel.VELOCITY) == Frame.BODY
                ? source.columns(Channel.VELOCITY)
                : axes.stream().map(axis -> source.column(Channel.VELOCITY, axis)).toList();
    }

    private Optional<String> way() {
        return new ModelUnits(model, run).suspicion().map(this::otherUnit).or(this::tooFast);
    }

    private Optional<String> tooFast() {
        UsualSpeed speed = new UsualSpeed(model, run);
        List<Integer> axes = speed.exceeded();
        return axes.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        source.says(
                                positions(axes),
                                "the body goes %s m/s on average, which is too fast: are these positions in mm? If so, map them with a scale of 0.001 (--mapping)"
                                        .formatted(
                                                Figures.shown(speed.speed(axes.getFirst()), 2))));
    }

    private String otherUnit(ModelUnits.Suspicion seen) {
        boolean isTooFar = seen.factor() < 1;
        return source.says(
                positions(seen.axes()),
                "the model moves as this does, but 1000 times %s: are these positions in %s? If so, map them with a scale of %s (--mapping, which is for all runs; if it is this one alone, in its file)"
                        .formatted(
                                isTooFar ? "less far" : "as far",
                                isTooFar ? "mm" : "km",
                                Figures.shown(seen.factor())));
    }

    /** Rates that are too fast for radians, as they may be. */
    Optional<Suspicion> turns() {
        double fastest = 0;
        for (int axis = 0; axis < 3; axis++) {
            fastest = Math.max(fastest, run.range(Channel.ANGULAR_VELOCITY, axis));
        }
        String axes = run.frame(Channel.ANGULAR_VELOCITY) == Frame.BODY ? "p, q, r" : "wx, wy, wz";
        return fastest > SEVERAL_TURNS && !inDegrees
                ? Optional.of(
                        Suspicion.ofTurns(
                                source.says(
                                        source.columns(Channel.ANGULAR_VELOCITY),
                                        "%s differ by up to %s rad/s"
                                                .formatted(axes, Figures.shown(fastest))),
                                "are they in degrees (--degrees, if all files are)?"))
                : Optional.empty();
    }
}
