package org.auvsim.diagnosis.run;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Runs of which nobody said which are to judge, told apart: of several, the last of each three; of
 * one, blocks of time.
 *
 * @param fit to look for causes in
 * @param heldOut to judge them
 * @param notice how it was done, in a sentence
 */
public record Split(List<MeasuredRun> fit, List<MeasuredRun> heldOut, String notice) {
    /** Blocks of a single run; the last of each three is held out. */
    private static final int BLOCKS = 6;

    /** The lists cannot be changed. */
    public Split {
        fit = List.copyOf(fit);
        heldOut = List.copyOf(heldOut);
    }

    /**
     * Splits runs.
     *
     * @throws IllegalArgumentException if there is none, or only one that is too short for that
     */
    public static Split of(List<MeasuredRun> runs) {
        if (runs.isEmpty()) {
            throw new IllegalArgumentException("there is no run to split");
        }
        return runs.size() == 1 ? ofOne(runs.getFirst()) : ofSeveral(runs);
    }

    private static Split ofSeveral(List<MeasuredRun> runs) {
        int count = Math.max(1, Math.round(runs.size() / 3f));
        List<MeasuredRun> heldOut = new ArrayList<>();
        for (int i = 1; i <= count; i++) {
            heldOut.add(runs.get(i * runs.size() / count - 1));
        }
        List<MeasuredRun> fit = new ArrayList<>(runs);
        fit.removeAll(heldOut);
        return new Split(
                fit,
                heldOut,
                "no held-out runs were named, so %s %s held out and %s fitted"
                        .formatted(
                                names(heldOut),
                                heldOut.size() == 1 ? "is" : "are",
                                fit.size() == 1 ? names(fit) + " is" : fit.size() + " are"));
    }

    private static String names(List<MeasuredRun> runs) {
        return runs.stream().map(MeasuredRun::name).collect(Collectors.joining(", "));
    }

    /**
     * Two blocks to fit and one to judge, twice; or once, if the run is short, or if its start is
     * known: that says most of what follows it.
     */
    private static Split ofOne(MeasuredRun run) {
        boolean isLong = run.size() >= BLOCKS * MeasuredRun.FEWEST;
        int blocks = isLong && run.start().isEmpty() ? BLOCKS : 3;
        if (run.size() < blocks * MeasuredRun.FEWEST) {
            throw new IllegalArgumentException(
                    "run '%s' has %d samples; expected %d to fit two thirds and hold out one: give a longer run, or another one to hold out"
                            .formatted(run.name(), run.size(), blocks * MeasuredRun.FEWEST));
        }
        List<MeasuredRun> fit = new ArrayList<>();
        List<MeasuredRun> heldOut = new ArrayList<>();
        double since = run.beginsFar() ? run.time(0) : 0;
        for (int block = 0; block < blocks; block += 3) {
            fit.add(part(run, fit.size() + heldOut.size(), block, block + 2, blocks));
            heldOut.add(part(run, fit.size() + heldOut.size(), block + 2, block + 3, blocks));
        }
        return new Split(
                fit,
                heldOut,
                "there is one run: its time is split, %s held out%s"
                        .formatted(
                                heldOut.stream()
                                        .map(part -> times(part, since))
                                        .collect(Collectors.joining(" and ")),
                                since == 0 ? "" : " (from its first row)"));
    }

    private static MeasuredRun part(MeasuredRun run, int number, int from, int to, int of) {
        return run.part(
                run.name() + "-" + (number + 1), from * run.size() / of, to * run.size() / of - 1);
    }

    private static String times(MeasuredRun run, double since) {
        return "%s to %s s"
                .formatted(shown(run.time(0) - since), shown(run.time(run.size() - 1) - since));
    }

    private static String shown(double time) {
        return new BigDecimal(time)
                .setScale(3, RoundingMode.HALF_EVEN)
                .stripTrailingZeros()
                .toPlainString();
    }
}
