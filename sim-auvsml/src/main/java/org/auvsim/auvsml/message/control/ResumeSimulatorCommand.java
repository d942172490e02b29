package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;

/** Lets a paused simulation go on (thesis, appendix A.1). */
public record ResumeSimulatorCommand() implements SimulatorCommand {
    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.resume();
        return Optional.empty();
    }
}
