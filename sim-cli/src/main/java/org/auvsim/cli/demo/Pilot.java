package org.auvsim.cli.demo;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.auvsml.message.control.StepCommand;

import java.util.List;

/**
 * The part of the robot's computer that flies the vehicle: it sends each setting of the plan when
 * its time has come, and asks for one step after the other, so that every flight gets the same
 * commands at the same times.
 */
final class Pilot {
    private final AuvsmlClient link;
    private final FlightPlan plan;
    private int sent;

    Pilot(AuvsmlClient link, FlightPlan plan) {
        this.link = link;
        this.plan = plan;
    }

    /** Sends the settings whose time has come, and then asks for a step. */
    void stepFrom(double time) throws ConnectionException {
        List<FlightPlan.Setting> settings = plan.settings();
        while (sent < settings.size() && settings.get(sent).at() <= time + 1e-9) {
            FlightPlan.Setting setting = settings.get(sent++);
            link.send(
                    set("Port Thruster", setting.port()),
                    set("Starboard Thruster", setting.starboard()),
                    set("Ventral Thruster", setting.ventral()));
        }
        link.send(new StepCommand(1));
    }

    private static SetPropulsorCommand set(String propulsor, double level) {
        return new SetPropulsorCommand(Demonstration.ROBOT_ID, propulsor, level);
    }
}
