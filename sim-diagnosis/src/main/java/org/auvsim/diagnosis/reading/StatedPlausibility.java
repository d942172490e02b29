package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.run.Run;
import org.auvsim.auvsml.run.TimedPush;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/** Whether what a document states of a file's runs can be of them. */
final class StatedPlausibility {
    /** A start that is further off than so many ranges and deviations is another one. */
    private static final double MANY = 5;

    private final Path document;
    private final Run stated;
    private final List<MeasuredRun> runs;
    private final List<Source> sources;

    StatedPlausibility(Path document, Run stated, List<MeasuredRun> runs, List<Source> sources) {
        this.document = document;
        this.stated = stated;
        this.runs = runs;
        this.sources = sources;
    }

    /** What looks wrong, with the document and its element. */
    List<String> notices() {
        List<String> notices = new ArrayList<>();
        for (TimedPush push : stated.scheduledForce()) {
            if (runs.stream().noneMatch(run -> acts(push, run))) {
                notices.add(never(push));
            }
        }
        for (int i = 0; i < runs.size(); i++) {
            String start =
                    stated.start().isPresent() ? document + ": start" : "the mapping's start";
            for (Channel channel : List.of(Channel.POSITION, Channel.VELOCITY)) {
                addFar(i, channel, start, notices);
            }
        }
        return notices;
    }

    private static boolean acts(TimedPush push, MeasuredRun run) {
        return push.from() < run.time(run.size() - 1) && push.until() > run.time(0);
    }

    private String never(TimedPush push) {
        MeasuredRun last = runs.getLast();
        return "%s: scheduled-force '%s': acts from %s s until %s s, but the rows of %s are from %s s until %s s, so that it does nothing; state its times by the rows' clock"
                .formatted(
                        document,
                        push.name(),
                        Figures.shown(push.from(), 9),
                        Figures.shown(push.until(), 9),
                        sources.getFirst().file(),
                        Figures.shown(runs.getFirst().time(0), 9),
                        Figures.shown(last.time(last.size() - 1), 9));
    }

    private void addFar(int i, Channel channel, String start, List<String> notices) {
        MeasuredRun run = runs.get(i);
        if (run.start().isEmpty() || run.frame(channel) == Frame.BODY) {
            return;
        }
        KnownStart known = run.start().get();
        boolean isPlace = channel == Channel.POSITION;
        Vec3 at = isPlace ? known.motion().position() : known.motion().velocity();
        double range = run.range(channel);
        for (int axis = 0; axis < 3; axis++) {
            OptionalInt first = first(run, channel, axis);
            double deviation = known.deviations().get((isPlace ? 0 : 6) + axis);
            double stated = at.component(axis);
            if (first.isPresent()) {
                double measured = run.value(channel, first.getAsInt(), axis);
                if (Math.abs(stated - measured) > MANY * (range + deviation)) {
                    notices.add(far(start, channel, axis, stated, measured, sources.get(i), range));
                    return;
                }
            }
        }
    }

    private static String far(
            String start,
            Channel channel,
            int axis,
            double stated,
            double measured,
            Source source,
            double range) {
        boolean isPlace = channel == Channel.POSITION;
        String unit = isPlace ? "m" : "m/s";
        return "%s/%s: %s is %s %s, but %s"
                .formatted(
                        start,
                        isPlace ? "position" : "velocity",
                        "xyz".substring(axis, axis + 1),
                        Figures.shown(stated),
                        unit,
                        source.says(
                                List.of(source.column(channel, axis)),
                                "the first that is measured is %s %s, and all of the run is within %s %s: is it the start of another run, or in other axes?"
                                        .formatted(
                                                Figures.shown(measured),
                                                unit,
                                                Figures.shown(range),
                                                unit)));
    }

    private static OptionalInt first(MeasuredRun run, Channel channel, int axis) {
        for (int k = 0; k < run.size(); k++) {
            if (!Double.isNaN(run.value(channel, k, axis))) {
                return OptionalInt.of(k);
            }
        }
        return OptionalInt.empty();
    }
}
