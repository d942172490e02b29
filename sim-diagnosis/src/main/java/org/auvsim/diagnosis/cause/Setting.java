package org.auvsim.diagnosis.cause;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Mount;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoublePredicate;
import java.util.stream.IntStream;

/**
 * A model, what was measured of it, and how large things are there: what is small, but can be told.
 *
 * @param path what the runs have seen of the world
 * @param rate typical size of the angular velocity (rad/s)
 */
record Setting(BelievedModel model, List<MeasuredRun> runs, Path path, double rate) {
    private static final double SLOWEST_TURN = 0.05;
    private static final List<Vec3> AXES =
            List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    /** What goes along a free way by less (sine) is held. */
    private static final double HELD = 1e-6;

    static Setting of(BelievedModel model, List<MeasuredRun> runs) {
        Path path = Path.of(runs, model.variant().body());
        double stated =
                runs.stream()
                        .flatMap(run -> run.start().filter(Setting::spins).stream())
                        .mapToDouble(start -> start.motion().angularVelocity().norm())
                        .max()
                        .orElse(0);
        double spin = Math.max(stated, model.start().angularVelocity().norm());
        double rate = Math.max(Turning.rate(runs), spin);
        return new Setting(model, runs, path, Math.max(SLOWEST_TURN, rate));
    }

    WorldObjectDefinition body() {
        return model.variant().body();
    }

    boolean measures(Channel channel) {
        return runs.stream().anyMatch(run -> run.measures(channel));
    }

    /** Whether the body is believed to float: it has buoyancy, or nothing pulls it down. */
    boolean floats() {
        return has(body(), Buoyancy.class) || !has(body(), Gravity.class);
    }

    /** Whether what holds a body lets its origin move along a direction (world). */
    static boolean goes(WorldObjectDefinition body, Vec3 direction) {
        return body.mount()
                .map(Mount::freeTranslations)
                .map(ways -> ways.stream().anyMatch(way -> Math.abs(way.dot(direction)) > HELD))
                .orElse(true);
    }

    /**
     * What a force's vector may be: nothing along an axis (world) along which the body cannot go,
     * unless it can go along none and forces turn it alone.
     */
    List<Parameter> forces(String name, String unit, double scale) {
        List<Parameter> along = new ArrayList<>();
        for (Parameter number : Parameter.vector(name, unit, scale)) {
            boolean isFelt = goes(body(), AXES.get(along.size()));
            along.add(isFelt ? number : Parameter.held(number.name(), unit, scale));
        }
        return along.stream().anyMatch(Parameter::isFree)
                ? along
                : Parameter.vector(name, unit, scale);
    }

    static boolean has(WorldObjectDefinition body, Class<?> effect) {
        return body.effect().stream().anyMatch(effect::isInstance);
    }

    /** Whether the body's turning shows, in what is measured of it or in where it goes. */
    boolean turnsMatter() {
        return measures(Channel.ORIENTATION)
                || measures(Channel.ANGULAR_VELOCITY)
                || body().component().stream().anyMatch(Actuator.class::isInstance)
                || body().force().stream().anyMatch(Setting::dependsOnTurning);
    }

    /** Whether the body is believed to spin when a run begins. */
    boolean isToSpin() {
        return model.start().angularVelocity().norm() > 0
                || runs.stream().anyMatch(run -> run.start().filter(Setting::spins).isPresent());
    }

    /** Whether it may spin though nothing tells so, as a ball of which only places are told. */
    boolean maySpin() {
        return !turnsMatter() && !isToSpin() && body().mount().isEmpty();
    }

    private static boolean spins(KnownStart start) {
        double deviation = 0;
        for (int i = 9; i < RigidMotion.SIZE; i++) {
            deviation = Math.max(deviation, start.deviations().get(i));
        }
        return start.motion().angularVelocity().norm() > deviation;
    }

    private static boolean dependsOnTurning(NamedForce force) {
        return force.frame() == Frame.BODY;
    }

    /** The propulsors that push in any of the runs. */
    List<Propulsor> propulsors() {
        return body().component().stream()
                .filter(Propulsor.class::isInstance)
                .map(Propulsor.class::cast)
                .filter(p -> isDirected(p) || p.level() != 0 || isCommanded(p, l -> l != 0))
                .toList();
    }

    /** Whether a behavior tells a propulsor what to do, where no run's commands do. */
    private boolean isDirected(Propulsor propulsor) {
        return body().directs(propulsor)
                && runs.stream()
                        .anyMatch(
                                run ->
                                        run.commands().stream()
                                                .noneMatch(c -> c.name().equals(propulsor.name())));
    }

    /**
     * Whether a propulsor pushes astern in any of the runs, or may where a behavior tells it to.
     */
    boolean goesAstern(Propulsor p) {
        return isDirected(p) || p.level() < 0 || isCommanded(p, level -> level < 0);
    }

    private boolean isCommanded(Component component, DoublePredicate is) {
        return runs.stream()
                .anyMatch(
                        run ->
                                run.commands().stream()
                                        .filter(c -> c.name().equals(component.name()))
                                        .anyMatch(c -> isTold(c, run.size(), is)));
    }

    private static boolean isTold(Command command, int samples, DoublePredicate is) {
        return IntStream.range(0, samples).mapToDouble(command::level).anyMatch(is);
    }

    /** Of the body, and the mean of what it carries of the water (kg). */
    double mass() {
        Vec3 carried = body().addedMass().map(a -> a.linear()).orElse(Vec3.ZERO);
        return body().mass().orElseThrow() + (carried.x() + carried.y() + carried.z()) / 3;
    }

    /** The mean of the body's moments of inertia (kg m^2). */
    double inertia() {
        Mat3 tensor = body().massProperties().orElseThrow().inertia();
        return (tensor.xx() + tensor.yy() + tensor.zz()) / 3;
    }

    /** Force (N) that brings the body to its speed within the longest run. */
    double force() {
        return mass() * path.speed() / path.duration();
    }

    /** Torque (N m), likewise. */
    double torque() {
        return inertia() * rate / path.duration();
    }

    /** Drag (N s/m) of that force at the typical speed. */
    double linearDrag() {
        return force() / path.speed();
    }

    /** Drag (N s^2/m^2), likewise. */
    double quadraticDrag() {
        return force() / (path.speed() * path.speed());
    }

    /** Longest step (s) of the world's time. */
    double timeStep() {
        return model.scenario().timeStep().delta();
    }

    /** A small number that can be told of a quantity with this unit. */
    double scale(String unit) {
        return switch (unit) {
            case "N" -> force();
            case "N m" -> torque();
            case "N s/m", "kg/s" -> linearDrag();
            case "N s^2/m^2", "kg/m" -> quadraticDrag();
            case "N m s/rad" -> torque() / rate;
            case "N m s^2/rad^2" -> torque() / (rate * rate);
            case "N s" -> force() * path.duration();
            case "N/m" -> force() / path.range();
            case "m/s" -> 0.1 * path.speed();
            case "rad/s" -> 0.1 * rate;
            case "kg" -> 0.1 * mass();
            case "kg m^2" -> 0.1 * inertia();
            case "m" -> 0.1 * path.range();
            case "s" -> 0.01 * path.duration();
            default -> 0.1;
        };
    }
}
