package org.auvsim.core.world;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.step.Collision;
import org.auvsim.core.step.StepResult;
import org.auvsim.core.step.StepStatistics;
import org.auvsim.core.step.StepTally;

/** What listeners are told of each step: collisions, movements, a report, and that it is done. */
final class StepNews {
    private final Population population;
    private final StepTally tally;
    private final Announcements announcements;
    private final StepTally atStart = new StepTally();

    StepNews(Population population, StepTally tally, Announcements announcements) {
        this.population = population;
        this.tally = tally;
        this.announcements = announcements;
    }

    void stepBegins() {
        atStart.set(tally);
    }

    void collisions(StepResult result) {
        for (int k = 0; k < result.collisions().size(); k++) {
            Collision collision = result.collisions().get(k);
            announcements.announce(new WorldEvent.Collided(collision.contact().time(), collision));
        }
    }

    /** A step is done, and has taken so long (s). */
    void stepDone(double time, double elapsed) {
        if (!announcements.isUnheard()) {
            movements(time);
            report(time, tally.since(atStart));
            announcements.announce(new WorldEvent.StepAdvanced(time, elapsed));
        }
    }

    private void movements(double time) {
        for (WorldObject object : population.objects()) {
            if (!object.isFixed()) {
                announcements.announce(
                        new WorldEvent.Moved(time, object.id(), object.movementState()));
            }
        }
    }

    private void report(double time, StepStatistics step) {
        if (step.subSteps() > 0
                || step.heldPairs() > 0
                || step.quickHits() > 0
                || step.crowdedHits() > 0
                || step.loweredHits() > 0
                || step.unsolvedIslands() > 0) {
            announcements.announce(
                    new WorldEvent.StepReport(
                            time,
                            step.subSteps(),
                            step.heldPairs(),
                            step.quickHits(),
                            step.crowdedHits(),
                            step.loweredHits(),
                            step.unsolvedIslands()));
        }
    }
}
