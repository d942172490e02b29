package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * One column of a regression on accelerations.
 *
 * @param cause that it belongs to, with the part of the body that it is about
 * @param change of reality by a little of it
 */
record Term(String cause, UnaryOperator<Reality> change) {
    private static final List<Vector3D> AXES =
            List.of(Vector3D.PLUS_I, Vector3D.PLUS_J, Vector3D.PLUS_K);

    /** All that are in proportion to their strength, more or less. */
    static List<Term> all(Scene scene) {
        List<Term> terms = new ArrayList<>();
        double mass = scene.plant().mass();
        double little = 0.01 * mass;
        terms.add(plant("linear_drag", p -> p.withDrag(d -> d.withEven(little, 0, 0))));
        terms.add(plant("quadratic_drag", p -> p.withDrag(d -> d.withEven(0, little, 0))));
        terms.add(plant("rotational_drag", p -> p.withDrag(d -> d.withEven(0, 0, little))));
        terms.add(plant("mass_error", p -> p.withMass(1.01 * p.mass())));
        terms.add(force("buoyancy_weight", at -> new Vector3D(0, 0, little)));
        terms.add(
                force(
                        "coulomb_friction",
                        at ->
                                at.velocity()
                                        .scalarMultiply(
                                                -little
                                                        / Math.max(
                                                                at.velocity().getNorm(), 0.01))));
        terms.add(
                force(
                        "magnus",
                        at ->
                                at.turningInWorld()
                                        .crossProduct(at.throughWater())
                                        .scalarMultiply(little)));
        for (Vector3D axis : AXES) {
            terms.add(
                    plant(
                            "anisotropic_drag",
                            p -> p.withDrag(d -> d.withQuadratic(axis.scalarMultiply(little)))));
            terms.add(plant("added_mass", p -> p.withAddedMass(p.addedMass().add(little, axis))));
            terms.add(
                    plant(
                            "cob_offset",
                            p -> p.withBuoyancyCentre(p.buoyancyCentre().add(0.001, axis))));
            terms.add(
                    plant(
                            "inertia_error",
                            p ->
                                    p.withInertia(
                                            p.inertia()
                                                    .add(
                                                            0.01,
                                                            Equations.times(p.inertia(), axis)))));
            terms.add(water("current_constant", (p, t) -> axis.scalarMultiply(0.01)));
            if (axis.getZ() == 0) {
                terms.add(water("current_shear", (p, t) -> axis.scalarMultiply(0.001 * p.getZ())));
            }
        }
        for (Thruster thruster : scene.plant().thrusters()) {
            terms.add(
                    plant(
                            "thruster_gain (%s)".formatted(thruster.name()),
                            p ->
                                    p.withThrusters(
                                            t ->
                                                    t.name().equals(thruster.name())
                                                            ? t.withGain(1.01)
                                                            : t)));
        }
        return terms;
    }

    private static Term plant(String cause, UnaryOperator<Plant> change) {
        return new Term(cause, r -> r.with(change));
    }

    private static Term water(String cause, Water water) {
        return new Term(cause, r -> r.in(water));
    }

    @FunctionalInterface
    private interface Law {
        Vector3D at(Instant instant);
    }

    private static Term force(String cause, Law law) {
        return new Term(cause, r -> r.pushed(at -> Wrench.force(law.at(at))));
    }
}
