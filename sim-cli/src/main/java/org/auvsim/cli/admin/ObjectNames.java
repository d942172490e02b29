package org.auvsim.cli.admin;

import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.entity.GetWorldObjectListCommand;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.cli.report.UserError;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/** The world objects of the simulator, asked for whenever a name is used. */
final class ObjectNames {
    private static final Duration PATIENCE = Duration.ofSeconds(5);

    private final Conversation conversation;

    ObjectNames(Conversation conversation) {
        this.conversation = conversation;
    }

    /**
     * The world objects as they are now.
     *
     * @throws UserError if the simulator does not tell
     */
    List<ListedWorldObject> all() {
        List<ListedWorldObject> objects = new ArrayList<>();
        for (Message answer : answers()) {
            if (answer instanceof WorldObjectListResponse list) {
                objects.addAll(list.worldObject());
            }
        }
        return objects;
    }

    private List<Message> answers() {
        try {
            return conversation.ask(List.of(new GetWorldObjectListCommand()), PATIENCE);
        } catch (ConnectionException e) {
            throw new UserError(String.valueOf(e.getMessage()), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new UserError("Interrupted while the simulator was asked for its objects.", e);
        }
    }

    /**
     * The id of the world object of this name.
     *
     * @throws UserError if there is none
     */
    long id(String name) {
        List<ListedWorldObject> objects = all();
        return objects.stream()
                .filter(object -> object.name().equals(name))
                .mapToLong(ListedWorldObject::id)
                .findFirst()
                .orElseThrow(
                        () ->
                                new UserError(
                                        "There is no world object '%s'; there is %s."
                                                .formatted(
                                                        name,
                                                        objects.stream()
                                                                .map(ListedWorldObject::name)
                                                                .toList())));
    }
}
