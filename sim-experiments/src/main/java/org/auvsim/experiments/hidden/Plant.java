package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.List;
import java.util.function.UnaryOperator;

/**
 * A rigid body whose origin is its centre of mass and whose axes are those of its inertia.
 *
 * @param size of the box (m) that it is drawn as, or diameter in x of a ball
 * @param mass (kg)
 * @param inertia principal moments (kg m^2)
 * @param addedMass of the water along each axis (kg)
 * @param addedInertia of the water about each axis (kg m^2)
 * @param gravity (m/s^2)
 * @param displaced mass of the water that it displaces (kg)
 * @param buoyancyCentre (m, body)
 */
record Plant(
        Vector3D size,
        double mass,
        Vector3D inertia,
        Vector3D addedMass,
        Vector3D addedInertia,
        double gravity,
        double displaced,
        Vector3D buoyancyCentre,
        Drag drag,
        List<Thruster> thrusters,
        List<Foil> foils) {
    static final double GRAVITY = 9.80665;

    boolean isBall() {
        return size.getY() == 0;
    }

    Plant withMass(double kilograms) {
        return new Plant(
                size,
                kilograms,
                inertia,
                addedMass,
                addedInertia,
                gravity,
                displaced,
                buoyancyCentre,
                drag,
                thrusters,
                foils);
    }

    Plant withInertia(Vector3D moments) {
        return new Plant(
                size,
                mass,
                moments,
                addedMass,
                addedInertia,
                gravity,
                displaced,
                buoyancyCentre,
                drag,
                thrusters,
                foils);
    }

    Plant withAddedMass(Vector3D kilograms) {
        return new Plant(
                size,
                mass,
                inertia,
                kilograms,
                addedInertia,
                gravity,
                displaced,
                buoyancyCentre,
                drag,
                thrusters,
                foils);
    }

    Plant withBuoyancyCentre(Vector3D centre) {
        return new Plant(
                size,
                mass,
                inertia,
                addedMass,
                addedInertia,
                gravity,
                displaced,
                centre,
                drag,
                thrusters,
                foils);
    }

    Plant withDrag(UnaryOperator<Drag> change) {
        return new Plant(
                size,
                mass,
                inertia,
                addedMass,
                addedInertia,
                gravity,
                displaced,
                buoyancyCentre,
                change.apply(drag),
                thrusters,
                foils);
    }

    Plant withThrusters(UnaryOperator<Thruster> change) {
        return new Plant(
                size,
                mass,
                inertia,
                addedMass,
                addedInertia,
                gravity,
                displaced,
                buoyancyCentre,
                drag,
                thrusters.stream().map(change).toList(),
                foils);
    }
}
