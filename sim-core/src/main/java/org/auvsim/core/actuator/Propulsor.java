package org.auvsim.core.actuator;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Need;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Vec3;

import java.util.Arrays;
import java.util.Optional;

/**
 * A propulsion device: pushes its object at a place and in a direction that are fixed to the body.
 *
 * <p>A commanded level passes the dead zone, then the lag; the level reached decides thrust, speed
 * of the rotor and power. Without lag, rotor and curve it pushes with {@code level * maximumThrust}
 * at once. A screw that moves ahead through the water bites less: of the thrust T that it has at
 * rest it loses {@code advanceLoss * sqrt(|T| * maximumThrust) * u}, u (m/s) being its speed along
 * the direction relative to the water, as T goes with the square of its revolutions and the loss
 * with these (the bilinear model of Blanke 1981).
 *
 * @param maximumThrust thrust (N) at level 1; with a thrust curve the limit (N) at which thrust
 *     saturates, ahead and astern
 * @param level as commanded, from -1 (full astern) to 1 (full ahead)
 * @param position where it pushes (m, body coordinates)
 * @param direction where it pushes to at a positive level (body axes; any length above 0)
 * @param thrustCurve thrust by level; empty: in proportion
 * @param lag time constant (s) with which the level follows a command; 0: at once
 * @param deadZone commanded levels up to this do nothing; from there on they grow evenly to 1
 * @param reactionTorque on the body about the direction, for each newton of thrust (N m/N); that of
 *     a propeller that is right-handed about its direction is negative
 * @param advanceLoss share of the maximum thrust that it loses at full revolutions for each metre
 *     per second that it moves ahead through the water (s/m): one by the speed at which a screw at
 *     full revolutions pushes no more; 0: thrust is the same at any speed
 * @param rotor what spins in it; needs a lag
 * @param powerDraw what it draws from a battery
 * @param condition what it does otherwise than it should; empty: nothing
 * @param reached the level it had reached at the last command; empty: it has settled
 */
public record Propulsor(
        String name,
        @Unit("N") double maximumThrust,
        @Default("0.0") double level,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0") Vec3 direction,
        Optional<ThrustCurve> thrustCurve,
        @Unit("s") @Default("0.0") double lag,
        @Default("0.0") double deadZone,
        @Unit("m") @Default("0.0") double reactionTorque,
        @Unit("s/m") @Default("0.0") double advanceLoss,
        Optional<Rotor> rotor,
        Optional<PowerDraw> powerDraw,
        Optional<Condition> condition,
        Optional<Reached> reached)
        implements Actuator {
    /**
     * A checked propulsor, its direction normalised.
     *
     * @throws IllegalArgumentException naming the propulsor and what is outside its range
     */
    public Propulsor {
        String of = Domain.named("propulsor", name);
        Domain.atLeast0(of, "maximum thrust", maximumThrust, "N");
        Domain.finite(of, "position", position, "m");
        Domain.require(-1 <= level && level <= 1, of, "level", level, "-1 to 1", "");
        Domain.atLeast0(of, "lag", lag, "s");
        Domain.require(
                0 <= deadZone && deadZone < 1, of, "dead zone", deadZone, "0 to below 1", "");
        Domain.finite(of, "reaction torque", reactionTorque, "N m/N");
        Domain.atLeast0(of, "advance loss", advanceLoss, "s/m");
        if (rotor.isPresent() && lag == 0) {
            throw new IllegalArgumentException(
                    "propulsor '%s' has a rotor and so needs a lag above 0 s: to spin up at once would"
                                    .formatted(name)
                            + " take a torque without end");
        }
        direction = Domain.unit(of, "direction", direction);
    }

    /** One that pushes in proportion to its level, at once. */
    public Propulsor(
            String name, double maximumThrust, double level, Vec3 position, Vec3 direction) {
        this(
                name,
                maximumThrust,
                level,
                position,
                direction,
                Optional.empty(),
                0,
                0,
                0,
                0,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    @Override
    public Optional<Need> needs() {
        return powerDraw.map(draw -> Need.named(Battery.class, draw.battery()));
    }

    @Override
    public double command() {
        return level;
    }

    /** The same propulsor at another level from a time (s) on, with what it has reached by then. */
    @Override
    public Propulsor commanded(double level, double time) {
        return with(level, settled(time), powerDraw.map(draw -> draw.plus(energy(time))));
    }

    private Optional<Reached> settled(double time) {
        return lag == 0 && powerDraw.isEmpty()
                ? Optional.empty()
                : Optional.of(new Reached(levelAt(time), time));
    }

    private Propulsor with(double level, Optional<Reached> reached, Optional<PowerDraw> draw) {
        return new Propulsor(
                name,
                maximumThrust,
                level,
                position,
                direction,
                thrustCurve,
                lag,
                deadZone,
                reactionTorque,
                advanceLoss,
                rotor,
                draw,
                condition,
                reached);
    }

    /** The same in another condition. */
    public Propulsor in(Condition other) {
        return built(direction, lag, advanceLoss, Optional.of(other));
    }

    /** The same in another direction (body axes), and following commands with another lag (s). */
    public Propulsor mounted(Vec3 otherDirection, double otherLag) {
        return built(otherDirection, otherLag, advanceLoss, condition);
    }

    /** The same that loses another share of its thrust by advance (s/m). */
    public Propulsor advancing(double otherLoss) {
        return built(direction, lag, otherLoss, condition);
    }

    private Propulsor built(
            Vec3 otherDirection,
            double otherLag,
            double otherLoss,
            Optional<Condition> otherCondition) {
        return new Propulsor(
                name,
                maximumThrust,
                level,
                position,
                otherDirection,
                thrustCurve,
                otherLag,
                deadZone,
                reactionTorque,
                otherLoss,
                rotor,
                powerDraw,
                otherCondition,
                reached);
    }

    /**
     * The same, with what it has drawn until a time (s) counted, and power or none from then on.
     */
    Propulsor counted(double time, boolean powered) {
        return with(level, settled(time), powerDraw.map(draw -> draw.counted(powered)));
    }

    /** What it has drawn until a time (s) and no battery has counted (J). */
    double uncounted(double time) {
        return powerDraw.map(draw -> draw.used() + energy(time)).orElse(0.0);
    }

    /** What it has drawn since the last command (J). */
    private double energy(double time) {
        if (powerDraw.isEmpty() || reached.isEmpty()) {
            return 0;
        }
        double seconds = Math.max(time - reached.get().at(), 0);
        return powerDraw.get().maximumPower() * course().cubeIntegral(seconds);
    }

    /** The level that it works at, at a time (s): the commanded one after dead zone and lag. */
    public double levelAt(double time) {
        double target = target();
        return Lag.level(levelBefore(target), target, Lag.left(lag, sinceCommand(time)));
    }

    private double levelBefore(double target) {
        return reached.isEmpty() ? target : reached.get().value();
    }

    private double sinceCommand(double time) {
        return reached.isEmpty() ? 0 : time - reached.get().at();
    }

    private Lag course() {
        double target = target();
        return new Lag(levelBefore(target), target, lag);
    }

    private double target() {
        double lost = condition.isEmpty() ? 0 : condition.get().lostLevel();
        double beyond = Math.abs(level) - lost - deadZone;
        if (beyond <= 0 || !(powerDraw.isEmpty() || powerDraw.get().powered())) {
            return 0;
        }
        return Math.copySign(beyond / (1 - deadZone), level);
    }

    /** Thrust (N) at a time (s), along the direction, at rest in the water. */
    public double thrustAt(double time) {
        return thrust(levelAt(time), time, 0);
    }

    /** The same at a level, and at a speed of advance (m/s). */
    private double thrust(double level, double time, double advance) {
        double turned = turning(level);
        double atRest = thrustAtRest(turned);
        double sound =
                advance == 0
                        ? atRest
                        : atRest
                                - advanceLoss
                                        * Math.sqrt(Math.abs(atRest) * maximumThrust)
                                        * advance;
        return condition.isEmpty() ? sound : sound * condition.get().share(turned, time);
    }

    /** A level, or the opposite one if its condition is to run backwards. */
    private double turning(double level) {
        return condition.isEmpty() ? level : condition.get().turning(level);
    }

    private double thrustAtRest(double level) {
        if (thrustCurve.isEmpty()) {
            return level * maximumThrust;
        }
        double free = thrustCurve.get().thrust(level);
        return Math.max(-maximumThrust, Math.min(maximumThrust, free));
    }

    @Override
    public Optional<Wrench> constantPush() {
        boolean changes = condition.isPresent() && condition.get().changes();
        if (rotor.isPresent() || (lag > 0 && reached.isPresent()) || changes || advanceLoss > 0) {
            return Optional.empty();
        }
        double thrust = thrust(target(), 0, 0);
        Vec3 force = direction.times(thrust);
        Vec3 torque = position.cross(force);
        return Optional.of(
                new Wrench(
                        force,
                        reactionTorque == 0
                                ? torque
                                : torque.plus(direction.times(reactionTorque * thrust))));
    }

    @Override
    public boolean isTimed() {
        return rotor.isEmpty() && advanceLoss == 0;
    }

    @Override
    public void push(Block b, double[] sum) {
        double left = Lag.left(lag, sinceCommand(b.time), b.exponentials);
        double thrust = thrust(course().level(left), b.time, 0);
        push(thrust, reactionTorque * thrust, sum);
    }

    /** Adds a thrust (N) and a torque about the direction (N m). */
    private void push(double thrust, double along, double[] sum) {
        double fx = direction.x() * thrust;
        double fy = direction.y() * thrust;
        double fz = direction.z() * thrust;
        sum[0] += fx;
        sum[1] += fy;
        sum[2] += fz;
        sum[3] += position.y() * fz - position.z() * fy + along * direction.x();
        sum[4] += position.z() * fx - position.x() * fz + along * direction.y();
        sum[5] += position.x() * fy - position.y() * fx + along * direction.z();
    }

    @Override
    public void add(Block b, int i) {
        Lag course = course();
        double left = Lag.left(lag, sinceCommand(b.time), b.exponentials);
        double advance = advanceLoss == 0 ? 0 : advance(b, i);
        double thrust = thrust(course.level(left), b.time, advance);
        double along = reactionTorque * thrust;
        double[] sum = b.push;
        Arrays.fill(sum, 0);
        if (rotor.isPresent()) {
            push(thrust, along - rotor.get().spin(turning(course.slope(left))), sum);
            resistTurning(b, i, rotor.get().spin(turning(course.level(left))), sum);
        } else {
            push(thrust, along, sum);
        }
        b.addFromBody(i, sum);
    }

    /** A rotor's angular momentum h (N m s) turns with the body: the torque on it is -w x h. */
    private void resistTurning(Block b, int i, double h, double[] sum) {
        double hx = h * direction.x();
        double hy = h * direction.y();
        double hz = h * direction.z();
        sum[3] -= b.bodyWy[i] * hz - b.bodyWz[i] * hy;
        sum[4] -= b.bodyWz[i] * hx - b.bodyWx[i] * hz;
        sum[5] -= b.bodyWx[i] * hy - b.bodyWy[i] * hx;
    }

    /** Its speed (m/s) along the direction, relative to the water around the body. */
    private double advance(Block b, int i) {
        double wx = b.vx[i] - b.ux[i];
        double wy = b.vy[i] - b.uy[i];
        double wz = b.vz[i] - b.uz[i];
        double vx = b.rxx[i] * wx + b.ryx[i] * wy + b.rzx[i] * wz;
        double vy = b.rxy[i] * wx + b.ryy[i] * wy + b.rzy[i] * wz;
        double vz = b.rxz[i] * wx + b.ryz[i] * wy + b.rzz[i] * wz;
        vx += b.bodyWy[i] * position.z() - b.bodyWz[i] * position.y();
        vy += b.bodyWz[i] * position.x() - b.bodyWx[i] * position.z();
        vz += b.bodyWx[i] * position.y() - b.bodyWy[i] * position.x();
        return vx * direction.x() + vy * direction.y() + vz * direction.z();
    }
}
