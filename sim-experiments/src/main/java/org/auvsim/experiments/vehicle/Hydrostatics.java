package org.auvsim.experiments.vehicle;

import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;

/**
 * What weight and buoyancy do to a vehicle at rest under water.
 *
 * @param weight (N)
 * @param buoyancy (N)
 * @param centreOfMass (m, body)
 * @param centreOfBuoyancy (m, body); the origin without buoyancy
 * @param displaced mass of the water that it displaces (kg)
 * @param density of that water (kg/m^3)
 */
record Hydrostatics(
        double weight,
        double buoyancy,
        Vec3 centreOfMass,
        Vec3 centreOfBuoyancy,
        double displaced,
        double density) {
    private static final double SEA_WATER = 1025;

    static Hydrostatics of(WorldObjectDefinition vehicle) {
        double mass = vehicle.mass().orElseThrow();
        double weight = 0;
        double buoyancy = 0;
        double displaced = 0;
        double density = SEA_WATER;
        Vec3 moment = Vec3.ZERO;
        for (Object effect : vehicle.effect()) {
            if (effect instanceof Gravity gravity) {
                weight += mass * gravity.acceleration();
            }
            if (effect instanceof Buoyancy lift) {
                double force = lift.displacedMass() * lift.acceleration();
                buoyancy += force;
                displaced += lift.displacedMass();
                density = lift.density();
                moment = moment.plus(lift.centre().times(force));
            }
        }
        return new Hydrostatics(
                weight,
                buoyancy,
                vehicle.centreOfMass().orElse(vehicle.volume().centreOfMass()),
                buoyancy > 0 ? moment.times(1 / buoyancy) : Vec3.ZERO,
                displaced,
                density);
    }

    /**
     * Torque about the centre of mass that rights it, for each radian of roll or pitch (N m/rad):
     * about any other point it depends on the point where weight and buoyancy differ.
     */
    double stiffness() {
        return buoyancy * metacentricHeight();
    }

    /** By how much buoyancy is more than weight, as a share of it; infinite without weight. */
    double excess() {
        return buoyancy / weight - 1;
    }

    /** Height of the centre of buoyancy above that of mass (m). */
    double metacentricHeight() {
        return centreOfBuoyancy.z() - centreOfMass.z();
    }
}
