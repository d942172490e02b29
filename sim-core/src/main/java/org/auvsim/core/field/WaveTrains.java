package org.auvsim.core.field;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Current;
import org.auvsim.core.math.Vec3;

/**
 * Linear waves that run over one another, ready to be evaluated (Airy 1845; Dean &amp; Dalrymple,
 * Water Wave Mechanics, 1991, chapter 3). With theta = k . x - omega t + phase each raises the
 * surface by a cos(theta); below it the water moves along the wave with a omega C cos(theta) and up
 * with a omega S sin(theta), where C and S are the ratios of cosh and sinh of k times the height
 * over the ground to sinh of k times the depth. Above still water the velocity is that at its
 * level, as linear theory ends there.
 */
final class WaveTrains implements Current {
    private final long id;
    private final String name;
    private final double surface;
    private final double depth;
    private final double alongX;
    private final double alongY;
    private final double[] amplitude;
    private final double[] omega;
    private final double[] k;
    private final double[] phase;

    /** exp(-2 k depth), by which the ground is felt. */
    private final double[] ground;

    /**
     * Waves of one direction.
     *
     * @param direction to which they run (rad from x to y)
     */
    WaveTrains(
            long id,
            String name,
            Water water,
            double direction,
            double[] amplitude,
            double[] omega,
            double[] phase) {
        this.id = id;
        this.name = name;
        surface = water.surface();
        depth = water.depth();
        alongX = StrictMath.cos(direction);
        alongY = StrictMath.sin(direction);
        this.amplitude = amplitude;
        this.omega = omega;
        this.phase = phase;
        k = new double[omega.length];
        ground = new double[omega.length];
        for (int n = 0; n < k.length; n++) {
            k[n] = Dispersion.wavenumber(omega[n], depth);
            ground[n] = StrictMath.exp(-2 * k[n] * depth);
        }
    }

    /**
     * What waves run on.
     *
     * @param surface height of still water (m, world)
     * @param depth below it (m); infinite for deep water
     */
    record Water(double surface, double depth) {}

    @Override
    public long id() {
        return id;
    }

    @Override
    public String name() {
        return name;
    }

    private double theta(int n, double x, double y, double time) {
        return k[n] * (alongX * x + alongY * y) - omega[n] * time + phase[n];
    }

    /** Height over still water, from the ground up to the surface. */
    private double clamped(double z) {
        return Math.min(0, Math.max(-depth, z - surface));
    }

    /** exp(k z) without what the ground adds. */
    private double decay(int n, double z) {
        return StrictMath.exp(k[n] * z);
    }

    /** exp(-k (z + 2 depth)), what the ground adds. */
    private double echo(int n, double decay) {
        return ground[n] == 0 ? 0 : ground[n] / decay;
    }

    @Override
    public double elevation(double x, double y, double time) {
        double sum = 0;
        for (int n = 0; n < k.length; n++) {
            sum += amplitude[n] * StrictMath.cos(theta(n, x, y, time));
        }
        return sum;
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        double z = clamped(position.z());
        double along = 0;
        double up = 0;
        for (int n = 0; n < k.length; n++) {
            double theta = theta(n, position.x(), position.y(), time);
            double decay = decay(n, z);
            double echo = echo(n, decay);
            double speed = amplitude[n] * omega[n] / (1 - ground[n]);
            along += speed * (decay + echo) * StrictMath.cos(theta);
            up += speed * (decay - echo) * StrictMath.sin(theta);
        }
        return new Vec3(alongX * along, alongY * along, up);
    }

    @Override
    public void addTo(Block b) {
        for (int i = 0; i < b.count; i++) {
            add(b, i);
        }
    }

    private void add(Block b, int i) {
        double x = b.state[BodyState.X][i];
        double y = b.state[BodyState.Y][i];
        double z = clamped(b.state[BodyState.Z][i]);
        double raised = 0;
        double along = 0;
        double up = 0;
        double alongByTime = 0;
        double upByTime = 0;
        double alongByWay = 0;
        double upByWay = 0;
        for (int n = 0; n < k.length; n++) {
            double theta = theta(n, x, y, b.time);
            double quarters = Circle.quarters(theta);
            double rest = Circle.rest(theta, quarters);
            double restSin = StrictMath.sin(rest);
            double restCos = StrictMath.cos(rest);
            double sin = Circle.sine(quarters, restSin, restCos);
            double cos = Circle.sine(quarters + 1, restSin, restCos);
            double decay = decay(n, z);
            double echo = echo(n, decay);
            double speed = amplitude[n] * omega[n] / (1 - ground[n]);
            double level = speed * (decay + echo);
            double rise = speed * (decay - echo);
            raised += amplitude[n] * cos;
            along += level * cos;
            up += rise * sin;
            alongByTime += omega[n] * level * sin;
            upByTime -= omega[n] * rise * cos;
            alongByWay -= k[n] * level * sin;
            upByWay += k[n] * rise * cos;
        }
        b.elevation[i] += raised;
        b.ux[i] += alongX * along;
        b.uy[i] += alongY * along;
        b.uz[i] += up;
        b.flow[0][i] += alongX * alongByTime;
        b.flow[1][i] += alongY * alongByTime;
        b.flow[2][i] += upByTime;
        addGradient(b, i, alongByWay, upByWay, b.state[BodyState.Z][i] - surface == z);
    }

    /**
     * The gradient of a flow without rotation that keeps its volume.
     *
     * @param isInWater whether the velocity changes with height, too
     */
    private void addGradient(Block b, int i, double along, double up, boolean isInWater) {
        b.flow[3][i] += alongX * alongX * along;
        b.flow[4][i] += alongX * alongY * along;
        b.flow[6][i] += alongX * alongY * along;
        b.flow[7][i] += alongY * alongY * along;
        b.flow[9][i] += alongX * up;
        b.flow[10][i] += alongY * up;
        if (isInWater) {
            b.flow[5][i] += alongX * up;
            b.flow[8][i] += alongY * up;
            b.flow[11][i] -= along;
        }
    }
}
