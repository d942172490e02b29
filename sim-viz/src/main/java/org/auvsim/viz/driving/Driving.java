package org.auvsim.viz.driving;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Turns what somebody wants an object to do into orders to its propulsors and fins. An object
 * without propulsors is pushed by a force of its own name.
 */
public final class Driving {
    /** The name of forces that a viewer sets. */
    public static final String FORCE = "Viewer";

    /** How hard a force without propulsors accelerates (m/s^2). */
    private static final double PUSH = 1;

    private final Thrust thrust;
    private final Steerage steerage;
    private final boolean hasPropulsors;
    private final double push;

    /** For an object that is made like this. */
    public Driving(WorldObjectDefinition object) {
        Vec3 centre = object.centreOfMass().orElse(object.volume().centreOfMass());
        List<Propulsor> propulsors = all(object, Propulsor.class);
        thrust = new Thrust(propulsors, centre);
        steerage = new Steerage(all(object, Fin.class), centre);
        hasPropulsors = !propulsors.isEmpty();
        push = object.fixed() ? 0 : object.mass().orElse(0) * PUSH;
    }

    private static <C extends Component> List<C> all(WorldObjectDefinition object, Class<C> kind) {
        return object.component().stream().filter(kind::isInstance).map(kind::cast).toList();
    }

    /** Whether anything can move it. */
    public boolean isPossible() {
        return hasPropulsors || push > 0;
    }

    /**
     * What its actuators are to do so that it does what is wanted, as far as they can.
     *
     * @param isAstern whether it goes astern through the water, where fins turn it the other way
     */
    public Orders orders(Wanted wanted, boolean isAstern) {
        Map<String, Double> angles = new HashMap<>();
        steerage.steer(wanted, isAstern, angles);
        if (hasPropulsors) {
            return new Orders(thrust.levels(wanted), angles, Optional.empty());
        }
        Vec3 force = new Vec3(wanted.surge() * push, wanted.sway() * push, wanted.heave() * push);
        return new Orders(
                Map.of(), angles, force.norm() > 0 ? Optional.of(force) : Optional.empty());
    }
}
