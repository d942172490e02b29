package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;

import java.util.Optional;

/**
 * Asks for the fins of a world object that can be turned.
 *
 * @param agentId any world object's id
 */
public record GetControlSurfaceListRequest(long agentId) implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        return Optional.of(
                new ControlSurfaceListResponse(
                        agentId,
                        world.controlSurfaceNames(agentId).stream()
                                .map(ListedControlSurface::new)
                                .toList()));
    }
}
