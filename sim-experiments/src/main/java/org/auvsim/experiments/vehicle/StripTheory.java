package org.auvsim.experiments.vehicle;

import java.util.function.DoubleUnaryOperator;

/**
 * What the sections of a long round hull do, each as a piece of an endless cylinder (Newman,
 * <i>Marine Hydrodynamics</i>, 1977, section 7.3; cross-flow drag: Hoerner, <i>Fluid-Dynamic
 * Drag</i>, 1965, section III).
 *
 * @param density of the water (kg/m^3)
 */
record StripTheory(Hull hull, double density) {
    /** Drag coefficient of a cylinder across the flow below its critical Reynolds number. */
    private static final double CROSS_FLOW = 1.1;

    private static final int STRIPS = 2000;

    /** Added mass of sway and of heave (kg). */
    double addedMass() {
        return overLength(x -> density * Math.PI * hull.radius(x) * hull.radius(x));
    }

    /** Added moment of inertia of pitch and of yaw about the middle (kg m^2). */
    double addedInertia() {
        return overLength(x -> density * Math.PI * hull.radius(x) * hull.radius(x) * x * x);
    }

    /** Force by square of the speed in sway and in heave (kg/m). */
    double drag() {
        return overLength(x -> density * CROSS_FLOW * hull.radius(x));
    }

    /** Torque by square of the rate in pitch and in yaw (kg m^2). */
    double turningDrag() {
        return overLength(x -> density * CROSS_FLOW * hull.radius(x) * Math.abs(x * x * x));
    }

    private double overLength(DoubleUnaryOperator ofSection) {
        double strip = hull.size().x() / STRIPS;
        double sum = 0;
        for (int k = 0; k < STRIPS; k++) {
            sum += ofSection.applyAsDouble((k + 0.5) * strip - hull.size().x() / 2);
        }
        return sum * strip;
    }
}
