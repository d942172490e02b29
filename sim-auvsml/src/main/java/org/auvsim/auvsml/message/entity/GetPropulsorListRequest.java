package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.command.WorldView;

import java.util.Optional;

/**
 * Asks for the propulsors of a world object (thesis, section 7.1).
 *
 * @param agentId any world object's id
 */
public record GetPropulsorListRequest(long agentId) implements WorldQuery {
    @Override
    public Optional<Message> execute(WorldView world) {
        return Optional.of(
                new PropulsorListResponse(
                        agentId,
                        world.propulsorNames(agentId).stream().map(ListedPropulsor::new).toList()));
    }
}
