package org.auvsim.junit;

import static org.auvsim.junit.Figures.text;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.step.StepException;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldException;

import java.util.Optional;

/** A scenario that is run on its own, without clients. */
record ScenarioRun(String name, Scenario scenario, double until) {
    Observed replay() throws ReplayException {
        requireEnd();
        World world = scenario.world();
        Observation observation = new Observation(world);
        while (world.time() < until - Trajectory.SAME_TIME) {
            step(world);
            observation.look();
        }
        return new Observed(
                name,
                /* ofRecording= */ false,
                scenario,
                world.time(),
                observation.tracks(_ -> Optional.empty()),
                observation.encounters(),
                Optional.empty());
    }

    private void requireEnd() throws ReplayException {
        if (Double.isNaN(until)) {
            throw new ReplayException(
                    "%s is a scenario, which has no end: say @ReplayScenario(value = \"%s\", until = ...)."
                            .formatted(name, name));
        }
        if (!(until > scenario.startTime()) || Double.isInfinite(until)) {
            throw new ReplayException(
                    "%s begins at %s s: until must be after that, but is %s s."
                            .formatted(name, text(scenario.startTime()), text(until)));
        }
    }

    private void step(World world) throws ReplayException {
        try {
            world.advanceTimestep();
        } catch (StepException | WorldException e) {
            throw new ReplayException(
                    "%s cannot be run beyond %s s: %s"
                            .formatted(name, text(world.time()), e.getMessage()),
                    e);
        }
    }
}
