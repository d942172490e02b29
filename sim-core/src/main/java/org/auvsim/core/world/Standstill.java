package org.auvsim.core.world;

import org.auvsim.core.step.StepResult;

/** Ends a world whose time does not move on, as bodies collide again and again. */
final class Standstill {
    /** So many steps in a row that do not move time mean that a collision never ends. */
    private static final int MOST_STEPS_AT_ONE_INSTANT = 10_000;

    private int stepsAtOneInstant;

    Standstill() {}

    Standstill(Standstill original) {
        stepsAtOneInstant = original.stepsAtOneInstant;
    }

    /**
     * Nothing if time moves on.
     *
     * @throws WorldException if it has not for too many steps
     */
    void guard(double time, StepResult result) {
        stepsAtOneInstant = result.elapsed() > 0 ? 0 : stepsAtOneInstant + 1;
        if (stepsAtOneInstant > MOST_STEPS_AT_ONE_INSTANT) {
            String who =
                    result.collisions().stream()
                            .findFirst()
                            .map(
                                    c ->
                                            c.contact().self().name()
                                                    + " and "
                                                    + c.contact().other().name())
                            .orElse("bodies");
            throw new WorldException(
                    "the world stands still at %s s: %s collide again and again; check their"
                                    .formatted(time, who)
                            + " collision responses");
        }
    }
}
