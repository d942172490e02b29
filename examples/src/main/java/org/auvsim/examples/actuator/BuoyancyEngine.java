package org.auvsim.examples.actuator;

import org.auvsim.core.actuator.Reached;
import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * The pump of a glider: moves oil into a bladder outside, so that the glider displaces more water,
 * or less. Density times g is 10,000 N/m^3 here.
 *
 * @param volume of the bladder as commanded, more or less than at neutral buoyancy (m^3)
 * @param rate with which the pump fills or empties it (m^3/s)
 * @param position of the bladder (m, body)
 * @param reached the volume reached at the last command
 */
public record BuoyancyEngine(
        String name,
        @Unit("m^3") @Default("0.0") double volume,
        @Unit("m^3/s") double rate,
        @Unit("m") @Default("0 0 0") Vec3 position,
        Optional<Reached> reached)
        implements Actuator {
    private static final double WEIGHT_OF_WATER = 10_000;

    @Override
    public double command() {
        return volume;
    }

    @Override
    public BuoyancyEngine commanded(double to, double time) {
        return new BuoyancyEngine(
                name, to, rate, position, Optional.of(new Reached(volumeAt(time), time)));
    }

    /** The bladder's volume (m^3) at a time (s): an exact function of it, whatever the step. */
    public double volumeAt(double time) {
        if (reached.isEmpty()) {
            return volume;
        }
        double way = volume - reached.get().value();
        double pumped = rate * (time - reached.get().at());
        return Math.abs(way) <= pumped
                ? volume
                : reached.get().value() + Math.copySign(pumped, way);
    }

    @Override
    public void add(Block block, int i) {
        Vec3 lift = new Vec3(0, 0, WEIGHT_OF_WATER * volumeAt(block.time));
        block.addForce(i, lift);
        block.addTorque(i, block.toWorld(i, position).cross(lift));
    }
}
