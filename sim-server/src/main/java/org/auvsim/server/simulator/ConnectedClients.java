package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.net.Notifications;

import java.util.List;

/** The clients as an administrator sees them. */
record ConnectedClients(
        Notifications notifications, ControlledObjects controlled, Members members) {
    /** All, in the order in which they came. */
    List<ListedClient> list() {
        List<ClientSession> missing = members.missing();
        return notifications.sessions().stream()
                .map(session -> listed(session, missing.contains(session)))
                .toList();
    }

    private ListedClient listed(ClientSession session, boolean isAwaited) {
        return new ListedClient(
                session.id(),
                session.name(),
                session.peer(),
                session.role().roleName(),
                isAwaited,
                controlled.of(session).stream().map(ListedClient.ControlledObject::new).toList());
    }

    /**
     * The one of this name, or else with this session id.
     *
     * @throws RefusedException if there is none
     */
    ClientSession named(String nameOrId) {
        return notifications.sessions().stream()
                .filter(session -> session.name().equals(nameOrId))
                .findFirst()
                .or(
                        () ->
                                notifications.sessions().stream()
                                        .filter(s -> Long.toString(s.id()).equals(nameOrId))
                                        .findFirst())
                .orElseThrow(() -> unknown(nameOrId));
    }

    private RefusedException unknown(String nameOrId) {
        return new RefusedException(
                ErrorCode.UNKNOWN_ENTITY,
                "there is no client '%s'; there is %s"
                        .formatted(
                                nameOrId,
                                notifications.sessions().stream()
                                        .map(ClientSession::name)
                                        .toList()));
    }
}
