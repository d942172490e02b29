package org.auvsim.diagnosis.model;

import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.ScheduledForce;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** What a run did to the body: commands of actuators, and forces. */
final class Inputs {
    private static final String AXES = "xyz";

    private final MeasuredRun run;
    private final List<Command> ofActuators = new ArrayList<>();
    private final List<CommandedForce> ofForces = new ArrayList<>();
    private final List<Behavior> overruled;

    /** Variants share most actuators: what was commanded before is worked out once for each. */
    private final IdentityHashMap<Component, Component> commandedBefore = new IdentityHashMap<>();

    /** A force of the scenario whose vector is commanded, by axis; an axis that is not stays. */
    private record CommandedForce(NamedForce force, List<Optional<Command>> byAxis) {
        boolean changesAt(int sample) {
            return byAxis.stream().flatMap(Optional::stream).anyMatch(c -> c.changesAt(sample));
        }

        NamedForce with(ToDoubleFunction<Command> level) {
            Vec3 v = force.vector();
            return new NamedForce(
                    force.name(),
                    force.frame(),
                    new Vec3(
                            along(0, level, v.x()), along(1, level, v.y()), along(2, level, v.z())),
                    force.point());
        }

        private double along(int axis, ToDoubleFunction<Command> level, double otherwise) {
            return byAxis.get(axis).map(level::applyAsDouble).orElse(otherwise);
        }
    }

    /** Those of a run on a body. */
    Inputs(MeasuredRun run, WorldObjectDefinition body) {
        this.run = run;
        for (Command command : run.commands()) {
            if (isActuator(body, command.name())) {
                ofActuators.add(command);
            }
        }
        for (NamedForce force : body.force()) {
            List<Optional<Command>> byAxis = new ArrayList<>();
            for (int axis = 0; axis < AXES.length(); axis++) {
                byAxis.add(command(force.name() + "." + AXES.charAt(axis)));
            }
            if (byAxis.stream().anyMatch(Optional::isPresent)) {
                ofForces.add(new CommandedForce(force, byAxis));
            }
        }
        overruled =
                body.component().stream()
                        .filter(Behavior.class::isInstance)
                        .map(Behavior.class::cast)
                        .filter(b -> isCommanded(b, body) || isPushed(b.name()))
                        .toList();
    }

    /** Whether the run commands an actuator that a behavior directs. */
    private boolean isCommanded(Behavior behavior, WorldObjectDefinition body) {
        return body.component().stream()
                .anyMatch(
                        c ->
                                c instanceof Actuator actuator
                                        && behavior.directs(actuator)
                                        && command(c.name()).isPresent());
    }

    /** Whether the run tells the force of a name, which that of a behavior would replace. */
    private boolean isPushed(String name) {
        return ofForces.stream().anyMatch(force -> force.force().name().equals(name))
                || run.forces().stream().anyMatch(f -> f.force().name().equals(name));
    }

    /** Behaviors that do not act, as the run tells what they would. */
    List<Behavior> overruled() {
        return overruled;
    }

    private Optional<Command> command(String name) {
        return command(run, name);
    }

    private static Optional<Command> command(MeasuredRun run, String name) {
        return run.commands().stream().filter(c -> c.name().equals(name)).findFirst();
    }

    private static boolean isActuator(WorldObjectDefinition body, String name) {
        return body.component().stream()
                .anyMatch(c -> c instanceof Actuator && c.name().equals(name));
    }

    /** Components that act, as the commands before a sample left them; always the same sample. */
    List<Component> before(int sample, List<Component> components) {
        List<Component> now = new ArrayList<>(components);
        now.removeAll(overruled);
        for (Command command : ofActuators) {
            now.replaceAll(
                    component ->
                            component instanceof Actuator actuator
                                            && component.name().equals(command.name())
                                    ? commandedBefore.computeIfAbsent(
                                            component,
                                            c -> before(sample, actuator, command.name()))
                                    : component);
        }
        return now;
    }

    /** A part of a run begins with what was commanded before it, on its way as far as it got. */
    private Actuator before(int sample, Actuator actuator, String name) {
        MeasuredRun whole = run.whole();
        Command command = command(whole, name).orElseThrow();
        Actuator now = actuator;
        for (int k = 0; whole.time(k) < run.time(sample); k++) {
            if (command.changesAt(k)) {
                now = now.commanded(command.level(k), whole.time(k));
            }
        }
        return now;
    }

    /** Whether a command changes at a sample. */
    boolean changeAt(int sample) {
        return ofActuators.stream().anyMatch(command -> command.changesAt(sample))
                || ofForces.stream().anyMatch(force -> force.changesAt(sample));
    }

    /** How often commands change from one sample to another, that of the first not counted. */
    int changes(int from, int to) {
        int changes = 0;
        for (int k = from + 1; k < to; k++) {
            changes += changeAt(k) ? 1 : 0;
        }
        return changes;
    }

    /** Gives bodies, at a time (s), the mean of what is commanded from one sample to another. */
    void commandMean(int from, int to, double time, List<WorldObject> bodies) {
        for (Command command : ofActuators) {
            command(command.name(), mean(command, from, to), time, bodies);
        }
        for (CommandedForce force : ofForces) {
            NamedForce now = force.with(command -> mean(command, from, to));
            bodies.forEach(body -> body.applyForce(now));
        }
    }

    /** Bodies that share an actuator go on sharing it: what it pushes is then worked out once. */
    private static void command(String name, double level, double time, List<WorldObject> bodies) {
        IdentityHashMap<Actuator, Actuator> commanded = new IdentityHashMap<>();
        for (WorldObject body : bodies) {
            Actuator before = body.component(Actuator.class, name).orElseThrow();
            if (before.command() != level) {
                body.replace(
                        commanded.computeIfAbsent(before, each -> each.commanded(level, time)));
            }
        }
    }

    private double mean(Command command, int from, int to) {
        double first = command.level(from);
        double more = 0;
        for (int k = from + 1; k < to; k++) {
            more += (command.level(k) - first) * (run.time(k + 1) - run.time(k));
        }
        return first + more / (run.time(to) - run.time(from));
    }

    /**
     * Gives bodies, at a time (s), what a sample commands; if they are new, also what was commanded
     * before.
     */
    void command(int sample, boolean areNew, double time, List<WorldObject> bodies) {
        for (Command command : ofActuators) {
            if (areNew || command.changesAt(sample)) {
                command(command.name(), command.level(sample), time, bodies);
            }
        }
        for (CommandedForce force : ofForces) {
            if (areNew || force.changesAt(sample)) {
                NamedForce now = force.with(command -> command.level(sample));
                bodies.forEach(body -> body.applyForce(now));
            }
        }
    }

    /**
     * Begins and ends scheduled forces as they are at a time (s), for the time after it. One that
     * ends takes away what has its name, also a force of the scenario, unless another begins.
     */
    void schedule(double time, double rounding, List<WorldObject> bodies) {
        double now = time + rounding;
        for (ScheduledForce scheduled : run.forces()) {
            if (scheduled.until() <= now) {
                bodies.forEach(body -> body.removeForce(scheduled.force().name()));
            }
        }
        for (ScheduledForce scheduled : run.forces()) {
            if (scheduled.from() <= now && now < scheduled.until()) {
                bodies.forEach(body -> body.applyForce(scheduled.force()));
            }
        }
    }

    /** The next time after one (s) at which a scheduled force begins or ends; or that given. */
    double nextChange(double after, double rounding, double atLatest) {
        double next = atLatest;
        for (ScheduledForce scheduled : run.forces()) {
            for (double edge : new double[] {scheduled.from(), scheduled.until()}) {
                if (edge > after + rounding && edge < next - rounding) {
                    next = edge;
                }
            }
        }
        return next;
    }
}
