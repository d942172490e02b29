package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Comparator;
import java.util.List;
import java.util.Set;

/**
 * How times of the world are told to people: as runs have them or, where these begin far from 0, as
 * UNIX time does, from the start of the run that they are in. Immutable.
 *
 * @param runs whose times count; without any all is told as it is
 */
public record Moments(List<MeasuredRun> runs) {
    /** All is told as it is. */
    public static final Moments PLAIN = new Moments(List.of());

    /** When something set in. */
    private static final String BEGUN = "from";

    private static final Set<String> NAMES = Set.of(BEGUN, "at");

    /** What fades does so from the world's time at which the first run begins. */
    private static final String FADE = "fade";

    private static final String FROM_THE_BEGINNING = " or from the beginning on";

    /** The list cannot be changed. */
    public Moments {
        runs = List.copyOf(runs);
    }

    /** Whether a number is a time of the world, when something began or was. */
    public static boolean isMoment(Quantity number) {
        return number.unit().equals("s") && NAMES.contains(number.name());
    }

    /** Whether what a cause does depends on the world's time: what swings has a phase at 0. */
    public static boolean isTimed(Finding cause) {
        return cause.quantities().stream()
                .anyMatch(
                        number ->
                                isMoment(number)
                                        || number.isFrequency()
                                        || number.name().equals(FADE));
    }

    /** Whether the runs begin far from 0. */
    public boolean areFar() {
        return runs.stream().anyMatch(MeasuredRun::beginsFar);
    }

    /** The time (s) at which the first of the runs begins; 0 without any. */
    public double begin() {
        return runs.stream().mapToDouble(run -> run.time(0)).min().orElse(0);
    }

    /** A number with its deviation and unit. */
    public String text(QuantityGroup of) {
        return toldFrom(of) + (mayBeAtTheBeginning(of) ? FROM_THE_BEGINNING : "");
    }

    private boolean mayBeAtTheBeginning(QuantityGroup of) {
        return of.name().equals(BEGUN)
                && !runs.isEmpty()
                && !of.deviations().isEmpty()
                && of.values().getFirst() - begin() <= Phrases.LIKELY * of.deviations().getFirst();
    }

    private String toldFrom(QuantityGroup of) {
        double time = of.values().getFirst();
        if (!areFar() || !isMoment(new Quantity(of.name(), of.unit(), time))) {
            return of.text();
        }
        MeasuredRun run = last(time);
        QuantityGroup since =
                new QuantityGroup(
                        of.name(), of.unit(), false, List.of(time - run.time(0)), of.deviations());
        return since.text() + " after the start of " + run.name();
    }

    /** A time (s) in a run: {@code 3.00 s of run1}. */
    public String text(double time, String run) {
        return runs.stream()
                .filter(each -> areFar() && each.name().equals(run))
                .findFirst()
                .map(
                        each ->
                                "%s s after the start of %s"
                                        .formatted(Numbers.rounded(time - each.time(0), 3), run))
                .orElseGet(() -> "%s s of %s".formatted(Numbers.rounded(time, 3), run));
    }

    /** The run that began last before a time, or else the first. */
    private MeasuredRun last(double time) {
        Comparator<MeasuredRun> byBegin = Comparator.comparingDouble(run -> run.time(0));
        return runs.stream()
                .filter(run -> run.time(0) <= time)
                .max(byBegin)
                .orElseGet(() -> runs.stream().min(byBegin).orElseThrow());
    }
}
