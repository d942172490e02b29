package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ClientCommand;
import org.auvsim.auvsml.message.command.Command;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.command.Role;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;
import org.auvsim.auvsml.message.command.SimulatorQuery;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.session.CommandDoneResponse;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.WelcomeMessage;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldException;
import org.auvsim.server.feedback.CorrectiveFeedbackSystem;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.net.Notifications;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Supplier;

/** Carries out what clients ask for, and answers. Belongs to the simulation thread. */
final class Requests {
    private static final Logger LOG = LoggerFactory.getLogger(Requests.class);
    private static final String PROTOCOL_VERSION = "1";

    private final World world;
    private final Notifications notifications;
    private final ControlledObjects controlled;
    private final CorrectiveFeedbackSystem feedback;
    private final SimulatorControl simulator;
    private final String serverName;

    /** Those who asked to leave, until they have got their answers. */
    private final Set<ClientSession> leaving = new HashSet<>();

    Requests(
            World world,
            Notifications notifications,
            ControlledObjects controlled,
            CorrectiveFeedbackSystem feedback,
            SimulatorControl simulator,
            String serverName) {
        this.world = world;
        this.notifications = notifications;
        this.controlled = controlled;
        this.feedback = feedback;
        this.simulator = simulator;
        this.serverName = serverName;
    }

    /** A client has come. */
    void begin(ClientSession session) {
        LOG.info("{} has come", session);
        notifications.add(session);
        session.send(
                new WelcomeMessage(
                        PROTOCOL_VERSION, serverName, session.id(), session.role().roleName()));
    }

    /** A client goes; what it controls is free again. */
    void end(ClientSession session) {
        if (notifications.sessions().contains(session)) {
            LOG.info("{} has gone", session);
        }
        controlled.releaseAll(session);
        session.close();
        notifications.remove(session);
    }

    /** Carries out the messages of one root element and answers them in one; each is on its own. */
    void carryOut(ClientSession session, Incoming.Request request) {
        List<Message> answers = new ArrayList<>();
        for (Message message : request.messages()) {
            if (isOpen(session)) {
                answer(session, message, request.requestId().isPresent()).ifPresent(answers::add);
            }
        }
        if (!answers.isEmpty() && !session.isClosed()) {
            session.send(request.requestId(), answers);
        }
        if (leaving.remove(session)) {
            end(session);
        }
        notifications.flush();
    }

    /** Answers what could not be read. */
    void refuse(ClientSession session, Incoming.Rejected rejected) {
        if (isOpen(session)) {
            session.send(rejected.requestId(), List.of(ErrorResponse.of(rejected.fault())));
        }
    }

    private boolean isOpen(ClientSession session) {
        return notifications.sessions().contains(session)
                && !leaving.contains(session)
                && !session.isClosed();
    }

    private Optional<Message> answer(ClientSession session, Message message, boolean always) {
        try {
            Optional<Message> response = execute(session, message);
            return response.isEmpty() && always ? Optional.of(new CommandDoneResponse()) : response;
        } catch (RefusedException e) {
            return Optional.of(ErrorResponse.of(e));
        } catch (WorldException | IllegalArgumentException e) {
            return Optional.of(error(ErrorCode.INVALID_VALUE, String.valueOf(e.getMessage())));
        } catch (RuntimeException e) {
            String name = message.getClass().getSimpleName();
            LOG.error("{} of {} failed", name, session, e);
            return Optional.of(
                    error(ErrorCode.REFUSED, name + " failed in the simulator; its log says why"));
        }
    }

    private static ErrorResponse error(ErrorCode code, String text) {
        return new ErrorResponse(code, text, OptionalInt.empty(), OptionalInt.empty());
    }

    private Optional<Message> execute(ClientSession session, Message message) {
        return switch (message) {
            case Command<?> command -> {
                requireRole(session, command.role(), command);
                yield execute(session, command);
            }
            case FeedbackMessage measured -> {
                requireRole(session, Role.CONTROLLER, measured);
                yield holding(session, measured.worldObjectId(), () -> take(session, measured));
            }
            default ->
                    throw new RefusedException(
                            ErrorCode.REFUSED,
                            "%s is a message that only the simulator sends"
                                    .formatted(message.getClass().getSimpleName()));
        };
    }

    private static void requireRole(ClientSession session, Role needed, Message message) {
        if (!session.role().allows(needed)) {
            throw new RefusedException(
                    ErrorCode.NOT_ALLOWED,
                    "%s needs the role %s, but %s is a %s"
                            .formatted(
                                    ElementName.of(message.getClass()),
                                    needed.roleName(),
                                    session.name(),
                                    session.role().roleName()));
        }
    }

    private Optional<Message> take(ClientSession session, FeedbackMessage measured) {
        feedback.take(new SessionSender(session), measured);
        return Optional.empty();
    }

    private Optional<Message> execute(ClientSession session, Command<?> command) {
        return switch (command) {
            case ClientCommand c ->
                    c.execute(
                            new SessionPort(
                                    session, world, controlled, () -> leaving.add(session)));
            case SimulatorQuery q -> q.execute(simulator);
            case SimulatorCommand c -> c.execute(simulator);
            case WorldQuery q -> q.execute(new WorldPort(world));
            case WorldCommand c -> c.execute(new WorldPort(world));
            case WorldObjectCommand c ->
                    holding(
                            session,
                            c.worldObjectId(),
                            () ->
                                    c.execute(
                                            new WorldObjectPort(
                                                    world, world.object(c.worldObjectId()))));
        };
    }

    /** Does something to an object that the client holds or, if it succeeds, gets hold of. */
    private Optional<Message> holding(
            ClientSession session, long objectId, Supplier<Optional<Message>> action) {
        boolean isNew = controlled.take(session, objectId);
        boolean done = false;
        try {
            Optional<Message> response = action.get();
            done = true;
            return response;
        } finally {
            if (isNew && !done) {
                controlled.release(session, objectId);
            }
        }
    }
}
