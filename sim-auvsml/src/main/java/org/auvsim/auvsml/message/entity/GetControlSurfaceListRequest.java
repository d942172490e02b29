package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.command.WorldView;

import java.util.Optional;

/**
 * Asks for the fins of a world object that can be turned.
 *
 * @param agentId any world object's id
 */
public record GetControlSurfaceListRequest(long agentId) implements WorldQuery {
    @Override
    public Optional<Message> execute(WorldView world) {
        return Optional.of(
                new ControlSurfaceListResponse(
                        agentId,
                        world.controlSurfaceNames(agentId).stream()
                                .map(ListedControlSurface::new)
                                .toList()));
    }
}
