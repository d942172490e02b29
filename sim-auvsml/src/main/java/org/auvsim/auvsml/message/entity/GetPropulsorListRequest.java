package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;

import java.util.Optional;

/**
 * Asks for the propulsors of a world object (thesis, section 7.1).
 *
 * @param agentId any world object's id
 */
public record GetPropulsorListRequest(long agentId) implements WorldCommand {
    @Override
    public Optional<Message> execute(WorldControl world) {
        return Optional.of(
                new PropulsorListResponse(
                        agentId,
                        world.propulsorNames(agentId).stream().map(ListedPropulsor::new).toList()));
    }
}
