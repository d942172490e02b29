package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Noise;

import java.util.Optional;

/**
 * Whether runs are told in another way than they are read: orientations, or which command is which.
 * Each is looked for once, when it is first asked for.
 */
public final class Misreading {
    /** Squares of what is missed (standard deviations) a number, where little is missed. */
    private static final double NEARLY = 5;

    private final Course course;
    private final Once<Optional<String>> orientations;
    private final Once<Optional<SwappedCommands.Swap>> surelySwapped;
    private final Once<Optional<SwappedCommands.Swap>> commands;

    /**
     * Of runs that the model as it is believed was fitted to.
     *
     * @param base what follows them by it
     */
    Misreading(Fit base, Judged none, Noise noise, Course course) {
        SwappedCommands swapped = new SwappedCommands(base, none, noise, course);
        this.course = course;
        this.orientations = new Once<>(() -> new MixedOrientations(none, course).notice());
        this.surelySwapped = new Once<>(swapped::certain);
        this.commands = new Once<>(() -> surelySwapped.get().or(swapped::nearest));
    }

    /**
     * What is to be said of it; empty where the runs are read as they are told, or nobody knows.
     */
    public Optional<String> notice() {
        return orientations.get().or(() -> commands.get().map(SwappedCommands.Swap::notice));
    }

    /** Whether two commands are swapped, and nothing else is wrong. */
    boolean isSurelyOfCommands() {
        return course.goesOn() && surelySwapped.get().isPresent();
    }

    /**
     * Whether orientations are told in another way, or commands where much is missed with what was
     * found: no cause is to explain that.
     */
    boolean isLikelierThan(Judged found) {
        return course.goesOn() && (isOfOrientations() || (!isNear(found) && isNearerThan(found)));
    }

    private static boolean isNear(Judged found) {
        return found.cost() < NEARLY * found.outcome().count();
    }

    private boolean isOfOrientations() {
        return orientations.get().isPresent();
    }

    /** Whether the runs, read in another way, are nearer to the model than what was found. */
    boolean isNearerThan(Judged found) {
        return isOfOrientations()
                || commands.get().filter(swap -> swap.with().cost() < found.cost()).isPresent();
    }
}
