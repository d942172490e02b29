package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorState;
import org.auvsim.core.description.Unit;

/**
 * How the simulator stands.
 *
 * @param running whether time goes on
 * @param rate world seconds a second that are aimed at, or {@code max}
 * @param step steps made
 * @param clients sessions that are open
 */
public record SimulatorStateResponse(
        @Unit("s") double time, boolean running, String rate, long step, int clients)
        implements Message {
    /** The response that states this. */
    public static SimulatorStateResponse of(SimulatorState state) {
        return new SimulatorStateResponse(
                state.time(),
                state.running(),
                SetRateCommand.text(state.rate()),
                state.step(),
                state.clients());
    }
}
