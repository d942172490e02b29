package org.auvsim.examples.messages;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.auvsml.message.entity.ListedPropulsor;

import java.util.List;
import java.util.Optional;

/** Shuts down some of a vehicle's propulsors: {@code <shut-down-propulsors id="4">...}. */
public record ShutDownPropulsors(long id, List<ListedPropulsor> propulsor)
        implements WorldObjectCommand {
    @Override
    public long worldObjectId() {
        return id;
    }

    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        propulsor.forEach(each -> object.setPropulsorLevel(each.name(), 0));
        return Optional.empty();
    }
}
