package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ClientCommand;
import org.auvsim.auvsml.message.command.Command;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;
import org.auvsim.auvsml.message.command.SimulatorQuery;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.entity.AddWorldObjectCommand;
import org.auvsim.auvsml.message.entity.AddWorldObjectResponse;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.server.feedback.CorrectiveFeedbackSystem;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.net.Notifications;

import java.util.HashSet;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Supplier;

/** What messages do: to the world, to the session of their sender, to the simulator. */
final class Execution {
    private final WorldPort world;
    private final ControlledObjects controlled;
    private final CorrectiveFeedbackSystem feedback;
    private final Members members;
    private final History history;
    private final Notifications notifications;
    private final SimulatorControl simulator;
    private final Set<ClientSession> ending = new HashSet<>();

    Execution(
            WorldPort world,
            ControlledObjects controlled,
            CorrectiveFeedbackSystem feedback,
            Members members,
            History history,
            Notifications notifications,
            SimulatorControl simulator) {
        this.world = world;
        this.controlled = controlled;
        this.feedback = feedback;
        this.members = members;
        this.history = history;
        this.notifications = notifications;
        this.simulator = simulator;
    }

    /**
     * Nothing if its sender may send this.
     *
     * @throws RefusedException if another role is needed, or clients do not send such a thing
     */
    void requireAllowed(Held held) {
        switch (held.message()) {
            case Command<?> command -> requireRole(held, command.role());
            case FeedbackMessage _ -> requireRole(held, Role.CONTROLLER);
            default ->
                    throw new RefusedException(
                            ErrorCode.REFUSED,
                            "%s is a message that only the simulator sends"
                                    .formatted(ElementName.of(held.message().getClass())));
        }
    }

    private static void requireRole(Held held, Role needed) {
        ClientSession session = held.session();
        if (!session.role().allows(needed)) {
            throw new RefusedException(
                    ErrorCode.NOT_ALLOWED,
                    "%s needs the role %s, but %s is a %s"
                            .formatted(
                                    ElementName.of(held.message().getClass()),
                                    needed.roleName(),
                                    session.name(),
                                    session.role().roleName()));
        }
    }

    /** Keeps a member's message until its step; feedback may be the member's answer to it. */
    void hold(Member member, Held held) {
        member.hold(held);
        if (held.message() instanceof FeedbackMessage measured
                && feedback.isForThisStep(measured.timestamp())) {
            member.corrects(
                    measured.worldObjectId(), controlled.of(held.session()), members.step());
        }
    }

    /**
     * Does what a message is for.
     *
     * @return the response to its sender, if it has one of its own
     */
    Optional<Message> execute(Held held) {
        Optional<Message> response = execute(held.session(), held.message());
        Message again = again(held.message(), response);
        switch (again) {
            case WorldCommand c -> remember(held.session(), c, () -> perform(c));
            case WorldObjectCommand c -> remember(held.session(), c, () -> perform(c));
            default -> {
                // it does nothing to the world, or is remembered as what it is, as feedback
            }
        }
        return response;
    }

    private void remember(ClientSession session, Message message, Runnable action) {
        history.add(new Deed(session, ElementName.of(message.getClass()), action));
    }

    private Optional<Message> perform(WorldCommand command) {
        return command.execute(world);
    }

    private Optional<Message> perform(WorldObjectCommand command) {
        WorldObject object = WorldPort.object(world.world(), command.worldObjectId());
        return command.execute(new WorldObjectPort(world.world(), object));
    }

    /** What leads to the same again: an object that was added keeps its id. */
    private static Message again(Message message, Optional<Message> response) {
        return message instanceof AddWorldObjectCommand add
                        && response.orElse(null) instanceof AddWorldObjectResponse added
                ? new AddWorldObjectCommand(
                        add.worldObject().withId(OptionalLong.of(added.worldObjectId())))
                : message;
    }

    private Optional<Message> execute(ClientSession session, Message message) {
        return switch (message) {
            case FeedbackMessage measured ->
                    holding(
                            session,
                            measured.worldObjectId(),
                            () -> {
                                feedback.take(new SessionSender(session), measured);
                                return Optional.empty();
                            });
            case ClientCommand c -> c.execute(port(session));
            case SimulatorQuery q -> q.execute(simulator);
            case SimulatorCommand c -> c.execute(simulator);
            case WorldQuery q -> q.execute(world);
            case WorldCommand c -> perform(c);
            case WorldObjectCommand c -> holding(session, c.worldObjectId(), () -> perform(c));
            default -> throw new AssertionError(message + " is not for the simulator");
        };
    }

    private SessionPort port(ClientSession session) {
        return new SessionPort(
                session,
                world.world(),
                controlled,
                name -> join(session, name),
                step -> members.ready(session, step),
                () -> ending.add(session));
    }

    private long join(ClientSession session, String name) {
        if (ClientSession.isGiven(name) && !name.equals(ClientSession.givenName(session.id()))) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "the name '%s' is one that the simulator gives; choose another"
                            .formatted(name));
        }
        for (ClientSession other : notifications.sessions()) {
            if (other != session && other.name().equals(name)) {
                throw new RefusedException(
                        ErrorCode.REFUSED,
                        "the name '%s' is that of another client; choose another".formatted(name));
            }
        }
        if (members.of(session).isPresent() && !session.name().equals(name)) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "this client is the member '%s' already".formatted(session.name()));
        }
        session.setName(name);
        return feedback.timestepper().isLockstep() ? members.join(session) : members.step() + 1;
    }

    /** Whether a client has asked to end its session. */
    boolean endsSession(ClientSession session) {
        return ending.remove(session);
    }

    /** What a client controls is free again. */
    void release(ClientSession session) {
        controlled.releaseAll(session);
    }

    /** Does something to an object that the client holds or, if it succeeds, gets hold of. */
    private Optional<Message> holding(
            ClientSession session, long objectId, Supplier<Optional<Message>> action) {
        controlled.requireFree(session, objectId);
        Optional<Message> response = action.get();
        controlled.take(session, objectId);
        return response;
    }
}
