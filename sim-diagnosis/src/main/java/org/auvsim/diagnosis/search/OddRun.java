package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Whiteness;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Whether the model as it is believed misses one run alone, and predicts at least two others to
 * their noise: what a model lacks shows in more of them; another vehicle or load, in that run.
 */
public final class OddRun {
    private static final int FEWEST_OTHERS = 2;

    private static final String ANOTHER =
            "was that another vehicle, or differently loaded, or did something happen to it? If so,"
                    + " leave it out, or diagnose it by itself";

    private OddRun() {}

    /** What is to be said of it; empty where no run is missed, or more than one, or few others. */
    public static Optional<String> notice(Judged... believed) {
        List<MeasuredRun> missed = new ArrayList<>();
        List<MeasuredRun> others = new ArrayList<>();
        for (Judged of : believed) {
            List<Misses> data = of.fit().data();
            for (int r = 0; r < data.size(); r++) {
                (isMissed(of, r) ? missed : others).add(data.get(r).run());
            }
        }
        return missed.size() != 1 || others.size() < FEWEST_OTHERS
                ? Optional.empty()
                : Optional.of(notice(missed.getFirst(), others));
    }

    private static String notice(MeasuredRun missed, List<MeasuredRun> others) {
        String names = others.stream().map(MeasuredRun::name).collect(Collectors.joining(", "));
        String why = copied(missed, others).map(OddRun::isCopied).orElse(ANOTHER);
        return "the model as it is predicts %s to the noise, and misses %s alone: %s"
                .formatted(names, missed.name(), why);
    }

    private static String isCopied(String from) {
        return "its commands are, row by row, those of %s alone; are they its own?".formatted(from);
    }

    /** The only one of several others that was told the same. */
    private static Optional<String> copied(MeasuredRun run, List<MeasuredRun> others) {
        List<MeasuredRun> toldAlike =
                others.stream().filter(other -> areToldAlike(run, other)).toList();
        return toldAlike.size() == 1 ? Optional.of(toldAlike.getFirst().name()) : Optional.empty();
    }

    private static boolean areToldAlike(MeasuredRun one, MeasuredRun other) {
        int rows = Math.min(one.size(), other.size());
        List<Command> commands = one.commands();
        return commands.stream().anyMatch(command -> changes(command, rows))
                && commands.stream().allMatch(command -> isToldIn(other, command, rows));
    }

    private static boolean changes(Command command, int rows) {
        return IntStream.range(1, rows).anyMatch(command::changesAt);
    }

    private static boolean isToldIn(MeasuredRun run, Command command, int rows) {
        return run.commands().stream()
                .filter(own -> own.name().equals(command.name()))
                .anyMatch(
                        own ->
                                IntStream.range(0, rows)
                                        .allMatch(k -> own.level(k) == command.level(k)));
    }

    private static boolean isMissed(Judged believed, int run) {
        return !(Whiteness.largest(
                        List.of(believed.outcome().misses().get(run)),
                        List.of(believed.fit().data().get(run)))
                < Whiteness.LIMIT);
    }
}
