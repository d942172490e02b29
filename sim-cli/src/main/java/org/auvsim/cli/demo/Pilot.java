package org.auvsim.cli.demo;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;

import java.util.List;
import java.util.Optional;

/** The client that flies the vehicle: it sends each setting of the plan when its time has come. */
final class Pilot {
    private final AuvsmlClient link;
    private final FlightPlan plan;
    private final double timeStep;
    private int sent;

    Pilot(AuvsmlClient link, FlightPlan plan, double timeStep) {
        this.link = link;
        this.plan = plan;
        this.timeStep = timeStep;
    }

    /** Sends what holds from the start, and asks to be told of each step. */
    void prepare() throws ConnectionException {
        link.send(Demonstration.register(EventType.TIMESTEP_ADVANCED));
        sendUntil(0);
    }

    /** Flies until the simulator ends the connection; returns how many settings were sent. */
    int fly() throws ConnectionException {
        Optional<Received> received = link.next();
        while (received.isPresent()) {
            for (Message message : received.get().messages()) {
                if (message instanceof TimestepAdvancedNotification step
                        && step.stateType() == StateType.ACTUAL) {
                    // What is sent now is done when the step that has begun is over.
                    sendUntil(step.timestamp() + timeStep);
                }
            }
            received = link.next();
        }
        return sent;
    }

    private void sendUntil(double time) throws ConnectionException {
        List<FlightPlan.Setting> settings = plan.settings();
        while (sent < settings.size() && settings.get(sent).at() <= time + 1e-9) {
            FlightPlan.Setting setting = settings.get(sent++);
            link.send(
                    set("Port Thruster", setting.port()),
                    set("Starboard Thruster", setting.starboard()),
                    set("Ventral Thruster", setting.ventral()));
        }
    }

    private static SetPropulsorCommand set(String propulsor, double level) {
        return new SetPropulsorCommand(Demonstration.ROBOT_ID, propulsor, level);
    }
}
