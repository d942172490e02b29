package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Growth;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Whether runs that nothing explains in one go are explained by one cause in parts, each with a
 * start of its own: what nothing steadies, as a torpedo's heading, goes elsewhere by the slightest
 * error of a start, and a fit gets lost on the way there.
 */
final class PartByPart {
    /** Runs are cut into so many. */
    private static final List<Integer> COUNTS = List.of(4, 8);

    /** Enough for what begins near. */
    private static final int STEPS = 12;

    /** What misses so much more than noise in parts is not explained in shorter ones either. */
    private static final double HOPELESS = 2;

    /** Where errors grow by more over a run, it is no run to be followed in one go. */
    private static final double FAR = 1000;

    /** By so much a cause must be better than none, in parts. */
    private static final double SURELY = 100;

    private final Stepping stepping;
    private final List<Misses> data;
    private final Noise noise;
    private final Course course;

    PartByPart(Stepping stepping, List<Misses> data, Noise noise, Course course) {
        this.stepping = stepping;
        this.data = List.copyOf(data);
        this.noise = noise;
        this.course = course;
    }

    /**
     * What is told of the best cause that does, in the longest parts; empty if none does.
     *
     * @param causes single ones, with numbers to begin at
     */
    Optional<String> notice(List<Hypothesis> causes) {
        for (int count : COUNTS) {
            List<Misses> parts = parts(count);
            if (parts.isEmpty() || causes.isEmpty() || !course.goesOn()) {
                return Optional.empty();
            }
            Fit followed = Following.of(stepping, Hypothesis.NONE, parts, noise, course);
            Judged best =
                    causes.stream()
                            .map(cause -> fitted(followed.with(cause, followed.windows())))
                            .min(Comparator.comparingDouble(Judged::score))
                            .orElseThrow();
            boolean isWorthIt = fitted(followed).score() - best.score() > SURELY;
            if (best.isWhite() && isWorthIt && course.goesOn() && isUnsteady(best.fit(), count)) {
                return Optional.of(words(best.fit().hypothesis(), parts));
            }
            if (!(best.cost() < HOPELESS * best.outcome().count())) {
                return Optional.empty();
            }
        }
        return Optional.empty();
    }

    /** All runs in so many parts each; none if these would be too short. */
    private List<Misses> parts(int count) {
        List<MeasuredRun> parts = new ArrayList<>();
        for (Misses of : data) {
            if (of.run().size() / count < MeasuredRun.FEWEST || of.run().isPart()) {
                return List.of();
            }
            parts.addAll(of.run().parts(count));
        }
        return Misses.of(parts, noise);
    }

    private Judged fitted(Fit begun) {
        Judged near = Refinement.approach(begun, 1, Double.POSITIVE_INFINITY, course).judged();
        return Descent.of(near).steps(STEPS, Double.POSITIVE_INFINITY, course);
    }

    /** Whether errors of a start grow far beyond themselves over a run. */
    private static boolean isUnsteady(Fit inParts, int count) {
        List<List<WindowDerivatives>> derivatives = inParts.derivatives(Moves.NONE);
        return IntStream.range(0, derivatives.size() / count)
                .mapToObj(run -> derivatives.subList(run * count, (run + 1) * count))
                .map(parts -> parts.stream().flatMap(List::stream).toList())
                .anyMatch(windows -> Growth.of(windows) > FAR);
    }

    private static String words(Hypothesis cause, List<Misses> parts) {
        double longest = parts.stream().mapToDouble(of -> of.run().duration()).max().orElseThrow();
        String seconds = Numbers.rounded(longest);
        return "in parts of %s s, each with a start of its own, the runs are explained by %s: over whole runs errors of the start grow more than a thousandfold; cut them into such parts (--parts %s)"
                .formatted(seconds, cause.causes().getFirst().label(), seconds);
    }
}
