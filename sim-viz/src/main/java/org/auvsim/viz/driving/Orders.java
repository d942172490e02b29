package org.auvsim.viz.driving;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What the actuators of an object are to do.
 *
 * @param levels of propulsors (-1 to 1), by their names
 * @param angles of fins (rad), by their names
 * @param force on an object without propulsors (N, body axes)
 */
public record Orders(Map<String, Double> levels, Map<String, Double> angles, Optional<Vec3> force) {
    /** None. */
    public static final Orders NONE = new Orders(Map.of(), Map.of(), Optional.empty());

    /** Keeps copies. */
    public Orders {
        levels = Map.copyOf(levels);
        angles = Map.copyOf(angles);
    }

    /** The messages that bring an object from other orders to these: only what differs. */
    public List<Message> since(Orders before, long id) {
        List<Message> messages = new ArrayList<>();
        levels.forEach(
                (name, level) -> {
                    if (!level.equals(before.levels.get(name))) {
                        messages.add(new SetPropulsorCommand(id, name, level));
                    }
                });
        angles.forEach(
                (name, angle) -> {
                    if (!angle.equals(before.angles.get(name))) {
                        messages.add(new SetControlSurfaceCommand(id, name, angle));
                    }
                });
        if (!force.equals(before.force)) {
            messages.add(
                    force.map(f -> push(id, f))
                            .orElseGet(() -> new RemoveForceCommand(id, Driving.FORCE)));
        }
        return messages;
    }

    /** All messages of these orders, whatever was ordered before. */
    public List<Message> all(long id) {
        List<Message> messages = new ArrayList<>(since(NONE, id));
        if (levels.isEmpty() && force.isEmpty()) {
            messages.add(new RemoveForceCommand(id, Driving.FORCE));
        }
        return messages;
    }

    private static Message push(long id, Vec3 force) {
        return new ApplyDirectForceCommand(id, Driving.FORCE, Frame.BODY, force);
    }
}
