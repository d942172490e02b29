package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Whether the model as it is comes far nearer to runs that nothing explains once two of their
 * commands are swapped: then the columns are mixed up, or the wires.
 */
public final class SwappedCommands {
    /** Enough to see which pair it is. */
    private static final int FIRST_STEPS = 3;

    /** Enough for the starts. */
    private static final int STEPS = 8;

    /** What is left of the squares of what is missed beyond noise; for there may be more wrong. */
    private static final double LEFT = 0.1;

    private final Judged none;
    private final Noise noise;
    private final Course course;

    /** Of the model as it is believed, fitted. */
    public SwappedCommands(Judged none, Noise noise, Course course) {
        this.none = none;
        this.noise = noise;
        this.course = course;
    }

    /** Two commands, and how well the model does with each told what the other was. */
    private record Swap(String one, String other, Judged with) {
        Swap further() {
            return new Swap(one, other, Descent.of(with.fit()).steps(STEPS));
        }
    }

    /** What is to be said of it; empty where no two do. */
    public Optional<String> notice() {
        return best().map(SwappedCommands::words);
    }

    /** Whether that comes nearer than what was found otherwise. */
    boolean areNearer(Judged found) {
        return best().filter(swap -> swap.with().cost() < found.cost()).isPresent();
    }

    /** The two that come nearest, if they come far nearer than none. */
    private Optional<Swap> best() {
        return pairs().parallelStream()
                .filter(_ -> course.goesOn())
                .map(pair -> swapped(pair.getFirst(), pair.getLast()))
                .min(Comparator.comparingDouble(swap -> swap.with().cost()))
                .map(Swap::further)
                .filter(swap -> beyondNoise(swap.with()) < LEFT * beyondNoise(none));
    }

    /** Those that were told something else at any time. */
    private List<List<String>> pairs() {
        List<String> names =
                none.fit().data().stream()
                        .flatMap(of -> of.run().commands().stream())
                        .map(Command::name)
                        .distinct()
                        .toList();
        List<List<String>> pairs = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            for (int k = i + 1; k < names.size(); k++) {
                pairs.add(List.of(names.get(i), names.get(k)));
            }
        }
        return pairs;
    }

    private Swap swapped(String one, String other) {
        Fit fit = none.fit();
        List<MeasuredRun> runs =
                fit.data().stream().map(of -> of.run().swapping(one, other)).toList();
        Fit swapped =
                new Fit(
                        fit.stepping(),
                        Misses.of(runs, noise),
                        fit.hypothesis(),
                        fit.windows(),
                        fit.knowledge());
        return new Swap(one, other, Descent.of(swapped).steps(FIRST_STEPS));
    }

    private static double beyondNoise(Judged of) {
        return of.cost() - of.outcome().count();
    }

    private static String words(Swap swap) {
        return "the model as it is predicts the runs far better if the commands of '%s' and '%s' are swapped: are these columns mixed up, or the wires of the vehicle? If so, rename the columns (--rename %s=%s,%s=%s)"
                .formatted(
                        swap.one(),
                        swap.other(),
                        swap.one(),
                        swap.other(),
                        swap.other(),
                        swap.one());
    }
}
