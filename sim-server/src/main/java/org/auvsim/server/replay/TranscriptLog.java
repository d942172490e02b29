package org.auvsim.server.replay;

import org.auvsim.core.world.World;
import org.auvsim.server.simulator.Input;
import org.auvsim.server.simulator.InputLog;
import org.auvsim.server.simulator.InputPlace;
import org.auvsim.server.simulator.StepMade;

/** Keeps the transcript of a replay, whose inputs are known already. */
record TranscriptLog(Transcript transcript) implements InputLog {
    @Override
    public void begun(World world) {
        transcript.begin(world);
    }

    @Override
    public void taken(InputPlace place, Input input) {
        // from the recording, or of viewers, who decide nothing
    }

    @Override
    public void stepFailed(InputPlace place) {
        // told by the step itself
    }

    @Override
    public void stepMade(StepMade step) {
        transcript.stepMade(step);
    }
}
