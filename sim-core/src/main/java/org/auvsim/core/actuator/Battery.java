package org.auvsim.core.actuator;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.WorldObject;

import java.util.List;

/**
 * What propulsors of an object draw their power from. Before each step it counts what they have
 * drawn, in closed form; once nothing is left, at the first step that begins then, their levels go
 * to 0, whatever is commanded. Its capacity is what a full one holds.
 *
 * @param charge what is left in it (J)
 */
public record Battery(String name, @Unit("J") double capacity, @Unit("J") double charge)
        implements Behavior {
    /**
     * A checked battery.
     *
     * @throws IllegalArgumentException if the capacity is not positive and finite, or the charge
     *     outside 0 to the capacity
     */
    public Battery {
        String of = Domain.named("battery", name);
        Domain.above0(of, "capacity", capacity, "J");
        Domain.require(
                0 <= charge && charge <= capacity,
                of,
                "charge",
                charge,
                "0 to its capacity of " + capacity + " J",
                "J");
    }

    /** Whether nothing is left in it. */
    public boolean isEmpty() {
        return charge == 0;
    }

    /**
     * What is left in it at a time (s), not before it last counted (J).
     *
     * @param propulsors all of its object, as they are now
     */
    public double chargeAt(double time, List<Propulsor> propulsors) {
        double drawn = 0;
        for (Propulsor propulsor : drawing(propulsors)) {
            drawn += propulsor.uncounted(time);
        }
        return Math.max(charge - drawn, 0);
    }

    private List<Propulsor> drawing(List<Propulsor> propulsors) {
        return propulsors.stream()
                .filter(p -> p.powerDraw().filter(d -> d.battery().equals(name)).isPresent())
                .toList();
    }

    @Override
    public void act(double time, WorldObject self) {
        List<Propulsor> propulsors = self.components(Propulsor.class);
        Battery left = new Battery(name, capacity, chargeAt(time, propulsors));
        for (Propulsor propulsor : drawing(propulsors)) {
            self.replace(propulsor.counted(time, !left.isEmpty()));
        }
        if (left.charge != charge) {
            self.replace(left);
        }
    }
}
