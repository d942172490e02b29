package org.auvsim.cli.admin;

import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.KeptSnapshot;
import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.control.ListSnapshotsRequest;
import org.auvsim.auvsml.message.control.SnapshotListResponse;
import org.auvsim.auvsml.message.entity.ControlSurfaceListResponse;
import org.auvsim.auvsml.message.entity.GetControlSurfaceListRequest;
import org.auvsim.auvsml.message.entity.GetPropulsorListRequest;
import org.auvsim.auvsml.message.entity.GetWorldObjectListCommand;
import org.auvsim.auvsml.message.entity.ListedControlSurface;
import org.auvsim.auvsml.message.entity.ListedPropulsor;
import org.auvsim.auvsml.message.entity.PropulsorListResponse;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.session.ClientListResponse;
import org.auvsim.auvsml.message.session.ListClientsRequest;
import org.auvsim.cli.report.UserError;

import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;

/** What has a name in the simulator, asked for whenever a name is used. */
final class KnownNames {
    private static final Duration PATIENCE = Duration.ofSeconds(5);

    private final Conversation conversation;

    KnownNames(Conversation conversation) {
        this.conversation = conversation;
    }

    /**
     * The id of a world object that is stated by its id or its name.
     *
     * @throws UserError if there is none of that name, or the simulator has gone
     */
    long id(String nameOrId) {
        if (nameOrId.matches("[0-9]{1,18}")) {
            return Long.parseLong(nameOrId);
        }
        List<ListedWorldObject> objects = objects();
        return objects.stream()
                .filter(object -> object.name().equals(nameOrId))
                .mapToLong(ListedWorldObject::id)
                .findFirst()
                .orElseThrow(
                        () ->
                                new UserError(
                                        "There is no world object '%s'; there is %s."
                                                .formatted(
                                                        nameOrId,
                                                        objects.stream()
                                                                .map(ListedWorldObject::name)
                                                                .toList())));
    }

    private List<ListedWorldObject> objects() {
        return answers(new GetWorldObjectListCommand(), WorldObjectListResponse.class)
                .flatMap(list -> list.worldObject().stream())
                .toList();
    }

    /**
     * What an attribute of a command may be.
     *
     * @param given the values of the attributes before it
     * @throws UserError if the simulator has gone
     */
    Stream<String> of(String element, String attribute, List<String> given) {
        if (Interpreter.IDS.contains(attribute)) {
            return objects().stream().map(ListedWorldObject::name);
        }
        return switch (element + "@" + attribute) {
            case "set-propulsor-command@name" -> propulsors(id(given.getFirst()));
            case "set-control-surface-command@name" -> controlSurfaces(id(given.getFirst()));
            case "take-snapshot-command@name", "restore-snapshot-command@name" -> snapshots();
            case "disconnect-client-command@client" -> clients();
            default -> Stream.of();
        };
    }

    private Stream<String> propulsors(long object) {
        return answers(new GetPropulsorListRequest(object), PropulsorListResponse.class)
                .flatMap(list -> list.propulsor().stream())
                .map(ListedPropulsor::name);
    }

    private Stream<String> controlSurfaces(long object) {
        return answers(new GetControlSurfaceListRequest(object), ControlSurfaceListResponse.class)
                .flatMap(list -> list.controlSurface().stream())
                .map(ListedControlSurface::name);
    }

    private Stream<String> snapshots() {
        return answers(new ListSnapshotsRequest(), SnapshotListResponse.class)
                .flatMap(list -> list.snapshot().stream())
                .map(KeptSnapshot::name);
    }

    private Stream<String> clients() {
        return answers(new ListClientsRequest(), ClientListResponse.class)
                .flatMap(list -> list.client().stream())
                .map(ListedClient::name);
    }

    private <M extends Message> Stream<M> answers(Message question, Class<M> answer) {
        try {
            return conversation.ask(List.of(question), PATIENCE).stream()
                    .filter(answer::isInstance)
                    .map(answer::cast);
        } catch (ConnectionException e) {
            throw new UserError(String.valueOf(e.getMessage()), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new UserError("Interrupted while the simulator was asked for names.", e);
        }
    }
}
