package org.auvsim.core.actuator;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.Domain;

import java.util.Optional;

/**
 * What a propulsor does otherwise than its data sheet says: a worn or fouled screw, one that runs
 * backwards, friction of its shaft, a failure, a battery that empties.
 *
 * @param gain share of its thrust that it gives; above 1 it is stronger than it should; below 0 it
 *     runs backwards, as one that is wired wrongly (-1): it gives such a share of its thrust at the
 *     opposite level
 * @param astern share of what is left that it gives while it turns astern (to a level below 0): a
 *     screw and its duct are shaped for going ahead
 * @param lostLevel of each commanded level this much is lost, 0 to below 1: of level x, sign(x)
 *     max(|x| - lost, 0) is left, which then passes the dead zone
 * @param failure of some of what is left, from some time on
 * @param sag by which what is left falls with time
 */
public record Condition(
        @Default("1.0") double gain,
        @Default("1.0") double astern,
        @Default("0.0") double lostLevel,
        Optional<Failure> failure,
        Optional<Sag> sag) {
    /** As the data sheet says. */
    public static final Condition SOUND =
            new Condition(1, 1, 0, Optional.empty(), Optional.empty());

    /**
     * A checked condition.
     *
     * @throws IllegalArgumentException naming the number that is out of its range
     */
    public Condition {
        Domain.finite("the condition of a propulsor", "gain", gain, "");
        Domain.atLeast0("the condition of a propulsor", "astern", astern, "");
        Domain.require(
                0 <= lostLevel && lostLevel < 1,
                "the condition of a propulsor",
                "lost level",
                lostLevel,
                "0 to below 1",
                "");
    }

    /** The share of its thrust that it gives while it turns to a level, at a time (s). */
    double share(double level, double time) {
        double share = level < 0 ? Math.abs(gain) * astern : Math.abs(gain);
        if (failure.isPresent()) {
            share *= failure.get().leftAt(time);
        }
        return sag.isEmpty() ? share : share * sag.get().leftAt(time);
    }

    /** Whether that depends on the time. */
    boolean changes() {
        return failure.isPresent() || sag.isPresent();
    }

    /** The same with another gain. */
    public Condition gaining(double otherGain) {
        return new Condition(otherGain, astern, lostLevel, failure, sag);
    }

    /** The same with another share astern. */
    public Condition pushingAstern(double otherShare) {
        return new Condition(gain, otherShare, lostLevel, failure, sag);
    }

    /** The same with another lost level. */
    public Condition losing(double otherLevel) {
        return new Condition(gain, astern, otherLevel, failure, sag);
    }

    /** The same with a failure. */
    public Condition failing(Failure how) {
        return new Condition(gain, astern, lostLevel, Optional.of(how), sag);
    }

    /** The same whose thrust falls with time. */
    public Condition sagging(Sag how) {
        return new Condition(gain, astern, lostLevel, failure, Optional.of(how));
    }

    /** The level of the same propulsor in a sound condition that turns to the same side. */
    double turning(double level) {
        return gain < 0 ? -level : level;
    }
}
