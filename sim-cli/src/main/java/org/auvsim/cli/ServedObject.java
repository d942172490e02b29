package org.auvsim.cli;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.entity.GetWorldObjectListCommand;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.cli.report.UserError;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** A world object of a simulator that this process is connected to. */
record ServedObject(long id, String name) {
    private static final int MOST_LISTED = 20;

    /** All world objects of a simulator. */
    static List<ServedObject> all(AuvsmlClient client) throws ConnectionException {
        List<ServedObject> objects = new ArrayList<>();
        for (Message message : Question.ask(client, new GetWorldObjectListCommand())) {
            if (message instanceof WorldObjectListResponse list) {
                for (ListedWorldObject object : list.worldObject()) {
                    objects.add(new ServedObject(object.id(), object.name()));
                }
            }
        }
        return objects;
    }

    /**
     * The one with a name, or else with an id.
     *
     * @throws UserError if there is none
     */
    static ServedObject named(List<ServedObject> all, String nameOrId) {
        Optional<ServedObject> named =
                all.stream().filter(object -> object.name().equals(nameOrId)).findFirst();
        return named.or(
                        () ->
                                all.stream()
                                        .filter(o -> Long.toString(o.id()).equals(nameOrId))
                                        .findFirst())
                .orElseThrow(() -> unknown(all, nameOrId));
    }

    private static UserError unknown(List<ServedObject> all, String nameOrId) {
        String known =
                all.stream()
                        .limit(MOST_LISTED)
                        .map(object -> "'%s' (id %d)".formatted(object.name(), object.id()))
                        .collect(Collectors.joining(", "));
        int more = all.size() - MOST_LISTED;
        return new UserError(
                "There is no world object '%s'; there %s."
                        .formatted(
                                nameOrId,
                                all.isEmpty()
                                        ? "are none"
                                        : "is "
                                                + known
                                                + (more > 0 ? " and " + more + " more" : "")));
    }
}
