package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Whether the model as it is explains runs that no cause explains, once their starts need not be
 * quite where they are stated: then these are wrong, or known less well than is said.
 */
final class SureStarts {
    /** As if they were known so many times less well. */
    private static final double LOOSER = 30;

    /** So many stated deviations no start is off by chance, among a dozen numbers of some runs. */
    private static final double SURELY = 5;

    private static final int STEPS = 12;

    /** So many runs are told one by one. */
    private static final int TOLD = 3;

    private static final List<String> PARTS =
            List.of("position", "orientation", "velocity", "angular velocity");

    private static final List<String> UNITS = List.of("m", "rad", "m/s", "rad/s");

    private final Stepping stepping;
    private final List<MeasuredRun> runs;
    private final Noise noise;
    private final Course course;

    SureStarts(Stepping stepping, List<MeasuredRun> runs, Noise noise, Course course) {
        this.stepping = stepping;
        this.runs = runs;
        this.noise = noise;
        this.course = course;
    }

    /** What is told of them, if they are. */
    Optional<String> notice() {
        if (runs.stream().allMatch(run -> stated(run).isEmpty()) || !course.goesOn()) {
            return Optional.empty();
        }
        Judged begun = begunFreely();
        List<String> off = begun.isWhite() ? off(begun) : List.of();
        if (off.isEmpty()) {
            return Optional.empty();
        }
        int told = Math.min(TOLD, off.size());
        String more = off.size() > told ? ", and so on (%d runs)".formatted(off.size()) : "";
        return Optional.of(
                "the model as it is explains all runs, if their starts need not be as stated: %s%s; state them less surely, or not at all"
                        .formatted(String.join(", ", off.subList(0, told)), more));
    }

    /** What is known of a run that begins midway nobody has stated. */
    private static Optional<KnownStart> stated(MeasuredRun run) {
        return run.start()
                .filter(at -> !run.beginsMidway())
                .filter(at -> at.deviations().stream().anyMatch(Double::isFinite));
    }

    private Judged begunFreely() {
        List<MeasuredRun> freely = runs.stream().map(SureStarts::loosened).toList();
        List<Misses> data = Misses.of(freely, noise);
        Judged near =
                Refinement.approach(
                        Following.of(stepping, Hypothesis.NONE, data, noise, course), 1);
        return Descent.of(near).steps(STEPS, Double.POSITIVE_INFINITY, course);
    }

    private static MeasuredRun loosened(MeasuredRun run) {
        return stated(run)
                .map(
                        at ->
                                new KnownStart(
                                        at.motion(),
                                        at.deviations().stream().map(d -> LOOSER * d).toList()))
                .map(run::startingAt)
                .orElse(run);
    }

    /** The number of each run's start that is furthest off, where one surely is. */
    private List<String> off(Judged begun) {
        List<String> off = new ArrayList<>();
        for (int r = 0; r < runs.size(); r++) {
            MeasuredRun run = runs.get(r);
            RigidMotion start = begun.fit().windows().get(r).getFirst().start();
            stated(run).flatMap(at -> off(run, at, start.minus(at.motion()))).ifPresent(off::add);
        }
        return off;
    }

    private static Optional<String> off(MeasuredRun run, KnownStart stated, double[] change) {
        return IntStream.range(0, change.length)
                .boxed()
                .filter(i -> deviations(stated, change, i) > SURELY)
                .max(Comparator.comparingDouble(i -> deviations(stated, change, i)))
                .map(i -> told(run, stated, i, change[i]));
    }

    private static double deviations(KnownStart stated, double[] change, int number) {
        return Math.abs(change[number]) / stated.deviations().get(number);
    }

    private static String told(MeasuredRun run, KnownStart stated, int number, double change) {
        String unit = UNITS.get(number / 3);
        return "the %s %s of %s is off by %s %s, and was stated to %s %s"
                .formatted(
                        PARTS.get(number / 3),
                        "xyz".charAt(number % 3),
                        run.name(),
                        Numbers.rounded(Math.abs(change)),
                        unit,
                        Numbers.rounded(stated.deviations().get(number)),
                        unit);
    }
}
