package org.auvsim.examples.client;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.movement.KinematicStateMessage;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.core.math.Vec3;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Steers a torpedo by waypoints through a sheared current, as {@code examples/clients/autopilot.py}
 * does: it holds the course over ground with its rudders and the depth with its stern planes.
 */
public final class Autopilot {
    /** m, east, north and up. */
    public static final List<Vec3> WAYPOINTS =
            List.of(
                    new Vec3(60, 0, -20),
                    new Vec3(90, 40, -14),
                    new Vec3(40, 70, -10),
                    new Vec3(0, 40, -16));

    private static final long VEHICLE = 1;

    /** A waypoint has been reached so near (m), seen from above. */
    private static final double NEAR = 4;

    /** Between two commands (s). */
    private static final double PERIOD = 0.1;

    /** As far as the fins are turned (rad): 13 degrees. */
    private static final double MOST = 0.227;

    private final Deque<Vec3> left;
    private double steered = Double.NEGATIVE_INFINITY;

    /** To fly to these waypoints (m, world), one after the other. */
    public Autopilot(List<Vec3> waypoints) {
        left = new ArrayDeque<>(waypoints);
    }

    /** Flies the vehicle of a server: {@code [host] [port]}. */
    public static void main(String[] args) {
        String host = args.length > 0 ? args[0] : "127.0.0.1";
        int port = args.length > 1 ? Integer.parseInt(args[1]) : 40001;
        try (AuvsmlClient client = AuvsmlClient.connect(host, port)) {
            if (!new Autopilot(WAYPOINTS).fly(client)) {
                System.err.println("The server has gone before the last waypoint.");
                System.exit(1);
            }
        } catch (ConnectionException e) {
            System.err.println(e.getMessage());
            System.exit(2);
        }
    }

    /**
     * Flies to all waypoints.
     *
     * @return false if the server ended the connection before
     * @throws IllegalStateException if it refuses something
     */
    public boolean fly(AuvsmlClient client) throws ConnectionException {
        client.send(
                ListenerRegistrationRequestCommand.of(
                        "" + VEHICLE, List.of(EventType.KINEMATIC_STATE)));
        Optional<Received> received = client.next();
        while (received.isPresent() && !left.isEmpty()) {
            for (Message message : received.get().messages()) {
                if (message instanceof ErrorResponse refusal) {
                    throw new IllegalStateException(refusal.text());
                }
                if (message instanceof KinematicStateMessage state) {
                    send(client, answer(state));
                }
            }
            received = client.next();
        }
        return left.isEmpty();
    }

    private static void send(AuvsmlClient client, List<SetControlSurfaceCommand> commands)
            throws ConnectionException {
        if (!commands.isEmpty()) {
            client.send(commands.toArray(Message[]::new));
        }
    }

    /** What it answers when the vehicle moves so: most often nothing. */
    List<SetControlSurfaceCommand> answer(KinematicStateMessage state) {
        Optional<Vec3> goal = Optional.ofNullable(left.peek());
        if (goal.isEmpty() || state.timestamp() - steered < PERIOD) {
            return List.of();
        }
        Vec3 way = goal.get().minus(state.position());
        if (Math.hypot(way.x(), way.y()) < NEAR) {
            System.out.printf(
                    Locale.ROOT,
                    "%7.1f s  %s reached at a height of %.1f m%n",
                    state.timestamp(),
                    left.remove(),
                    state.position().z());
            return List.of();
        }
        steered = state.timestamp();
        return steer(state, way);
    }

    private static List<SetControlSurfaceCommand> steer(KinematicStateMessage state, Vec3 way) {
        Vec3 over = state.velocity();
        double offCourse =
                Math.IEEEremainder(
                        Math.atan2(way.y(), way.x()) - Math.atan2(over.y(), over.x()), 2 * Math.PI);
        double climb = Math.asin(Math.clamp(state.quaternion().toMatrix().zx(), -1, 1));
        double wanted = Math.clamp(0.12 * way.z(), -0.35, 0.35);
        double yawing = state.bodyAngularVelocity().z();
        double sinking = state.bodyAngularVelocity().y();
        double rudder = Math.clamp(0.6 * (offCourse - yawing), -MOST, MOST);
        double plane = Math.clamp(1.5 * (climb - wanted) - 0.8 * sinking, -MOST, MOST);
        return List.of(
                new SetControlSurfaceCommand(VEHICLE, "Upper Rudder", rudder),
                new SetControlSurfaceCommand(VEHICLE, "Lower Rudder", rudder),
                new SetControlSurfaceCommand(VEHICLE, "Port Stern Plane", plane),
                new SetControlSurfaceCommand(VEHICLE, "Starboard Stern Plane", plane));
    }

    /** How many waypoints are left. */
    int left() {
        return left.size();
    }
}
