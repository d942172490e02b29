package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.auvsim.experiments.hidden.Manoeuvre.TimedPush;

import java.util.Arrays;
import java.util.List;

/**
 * The equations of motion of a rigid body with added mass in moving water (Newton and Euler in body
 * axes; Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control, 2021, chapters 3, 6 and
 * 10), between two times at which something sets in or ends. Added mass is accelerated relative to
 * the water, the water's own acceleration pushes what it surrounds (Auton, Hunt and Prud'homme,
 * Journal of Fluid Mechanics 197, 1988).
 *
 * <p>State: {@link Instant#SIZE} numbers of the body, a level a thruster, what companions are.
 */
final class Equations implements FirstOrderDifferentialEquations {
    private final Reality reality;
    private final Plant plant;
    private final List<Companion> companions;
    private final int[] sizes;
    private final int dimension;
    private double[] thrusterLevels;
    private double[] foilAngles;
    private List<TimedPush> pushes = List.of();
    private double now;

    Equations(Reality reality, List<Companion> companions, int[] sizes) {
        this.reality = reality;
        this.plant = reality.plant();
        this.companions = companions;
        this.sizes = sizes;
        this.dimension = Instant.SIZE + plant.thrusters().size() + Arrays.stream(sizes).sum();
        this.thrusterLevels = new double[plant.thrusters().size()];
        this.foilAngles = new double[plant.foils().size()];
    }

    /** What holds from now (s) on until told otherwise. */
    void hold(double time, double[] levels, double[] angles, List<TimedPush> acting) {
        now = time;
        thrusterLevels = levels;
        foilAngles = angles;
        pushes = acting;
    }

    @Override
    public int getDimension() {
        return dimension;
    }

    @Override
    public void computeDerivatives(double t, double[] y, double[] slope) {
        Instant at = Instant.of(t, y, reality.water());
        Wrench wrench = outside(at).plus(companions(at, y, slope));
        Attitude attitude = at.attitude();
        Vector3D w = at.turning();
        Vector3D through = attitude.toBody(at.throughWater());
        Vector3D flow = reality.water().acceleration(at.position(), t);
        Vector3D force =
                attitude.toBody(wrench.force().add(plant.displaced(), flow))
                        .add(plant.drag().force(through));
        Vector3D torque =
                attitude.toBody(wrench.torque())
                        .add(plant.drag().torque(w))
                        .add(
                                plant.buoyancyCentre()
                                        .crossProduct(
                                                attitude.toBody(
                                                        upward(plant.displaced())
                                                                .add(plant.displaced(), flow))));
        Wrench own = actuators(y, through, w, slope);
        accelerate(
                slope,
                attitude,
                w,
                through,
                force.add(times(plant.addedMass(), attitude.toBody(flow))).add(own.force()),
                torque.add(own.torque()));
        Instant.put(at.velocity(), slope, 0);
        turn(y, w, slope);
    }

    private Vector3D upward(double mass) {
        return new Vector3D(0, 0, mass * plant.gravity());
    }

    /** What acts from outside but drag (world axes). */
    private Wrench outside(Instant at) {
        Wrench sum = Wrench.force(upward(plant.displaced() - plant.mass()));
        for (Force force : reality.forces()) {
            sum = sum.plus(force.on(at));
        }
        for (TimedPush push : pushes) {
            Vector3D lever = at.attitude().toWorld(push.point());
            sum = sum.plus(new Wrench(push.force(), lever.crossProduct(push.force())));
        }
        return sum;
    }

    private Wrench companions(Instant at, double[] y, double[] slope) {
        Wrench sum = Wrench.NONE;
        int from = Instant.SIZE + plant.thrusters().size();
        for (int c = 0; c < companions.size(); c++) {
            double[] own = Arrays.copyOfRange(y, from, from + sizes[c]);
            sum = sum.plus(companions.get(c).on(at, own));
            double[] change = companions.get(c).slopes(at, own);
            System.arraycopy(change, 0, slope, from, sizes[c]);
            from += sizes[c];
        }
        return sum;
    }

    /** What thrusters and fins do (body axes). */
    private Wrench actuators(double[] y, Vector3D through, Vector3D w, double[] slope) {
        Wrench sum = Wrench.NONE;
        for (int i = 0; i < thrusterLevels.length; i++) {
            Thruster thruster = plant.thrusters().get(i);
            double target = thruster.target(thrusterLevels[i]);
            boolean lags = thruster.lag() > 0;
            double reached = lags ? y[Instant.SIZE + i] : target;
            slope[Instant.SIZE + i] = lags ? (target - reached) / thruster.lag() : 0;
            // The time that counts is that of the segment: nothing is lost within it.
            Vector3D push = thruster.direction().scalarMultiply(thruster.thrust(reached, now));
            sum = sum.plus(new Wrench(push, thruster.position().crossProduct(push)));
        }
        for (int i = 0; i < foilAngles.length; i++) {
            Foil foil = plant.foils().get(i);
            Vector3D push = foil.force(through.add(w.crossProduct(foil.position())), foilAngles[i]);
            sum = sum.plus(new Wrench(push, foil.position().crossProduct(push)));
        }
        return sum;
    }

    private void accelerate(
            double[] slope,
            Attitude attitude,
            Vector3D w,
            Vector3D through,
            Vector3D force,
            Vector3D torque) {
        Vector3D added = plant.addedMass();
        Vector3D momentum = times(added, through);
        Vector3D net =
                force.subtract(w.crossProduct(momentum)).add(times(added, w.crossProduct(through)));
        Vector3D inertial =
                new Vector3D(
                        net.getX() / (plant.mass() + added.getX()),
                        net.getY() / (plant.mass() + added.getY()),
                        net.getZ() / (plant.mass() + added.getZ()));
        Instant.put(attitude.toWorld(inertial), slope, 7);
        Vector3D moments = plant.inertia().add(plant.addedInertia());
        Vector3D turning =
                torque.subtract(w.crossProduct(times(moments, w)))
                        .subtract(through.crossProduct(momentum));
        Instant.put(
                new Vector3D(
                        turning.getX() / moments.getX(),
                        turning.getY() / moments.getY(),
                        turning.getZ() / moments.getZ()),
                slope,
                10);
    }

    private static void turn(double[] y, Vector3D w, double[] slope) {
        Attitude change =
                new Attitude(y[3], y[4], y[5], y[6])
                        .after(new Attitude(0, w.getX() / 2, w.getY() / 2, w.getZ() / 2));
        slope[3] = change.w();
        slope[4] = change.x();
        slope[5] = change.y();
        slope[6] = change.z();
    }

    static Vector3D times(Vector3D a, Vector3D b) {
        return new Vector3D(a.getX() * b.getX(), a.getY() * b.getY(), a.getZ() * b.getZ());
    }
}
