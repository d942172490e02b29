package org.auvsim.diagnosis.model;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.TimeStep;
import org.auvsim.auvsml.mapping.Names;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.Mount;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The model as it is believed: a scenario, and which of its bodies was measured.
 *
 * @param scenario a whole world
 * @param body the name of the body
 */
public record BelievedModel(Scenario scenario, String body) {
    /**
     * A checked model.
     *
     * @throws IllegalArgumentException if the scenario has no such body, or it cannot move
     */
    public BelievedModel {
        if (definition(scenario, body).fixed()) {
            throw new IllegalArgumentException(
                    "'%s' is fixed in the scenario; a body that moves is needed".formatted(body));
        }
    }

    private static WorldObjectDefinition definition(Scenario scenario, String body) {
        return scenario.worldObject().stream()
                .filter(object -> object.name().equals(body))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(lacks(scenario, body)));
    }

    private static String lacks(Scenario scenario, String body) {
        List<String> names =
                scenario.worldObject().stream().map(WorldObjectDefinition::name).toList();
        return "the scenario has no world object '%s'; it has %s%s"
                .formatted(
                        body,
                        names,
                        Names.meant(Names.near(body, names)).map("; "::concat).orElse(""));
    }

    /** Others that move and may run into the body: a diagnosis leaves them out. */
    public List<String> leftOut() {
        return company().movers().stream().map(WorldObjectDefinition::name).toList();
    }

    /**
     * Why a diagnosis cannot do without another body: it moves, too, and is tied to this one. Empty
     * if there is none.
     */
    public Optional<String> tie() {
        return company()
                .tied()
                .map(
                        other ->
                                "'%s' is tied to '%s', which moves, too; a diagnosis moves the measured body alone: fix '%s' (fixed=\"1\") if it hardly moves, or take the tie out and give what it does as a force of '%s', by columns or by a document beside each run"
                                        .formatted(body, other.name(), other.name(), body));
    }

    private Company company() {
        return new Company(scenario, definition(scenario, body));
    }

    /** Whether nothing in the scenario is in the body's way. */
    public boolean touchesNothing() {
        return Ground.under(this).objects().isEmpty();
    }

    /** A motion that begins beside all that is in the body's way: moved out if it is within. */
    public RigidMotion beside(RigidMotion motion) {
        return Ground.under(this).beside(variant().body().volume(), motion);
    }

    /** How the body moves at the beginning by the scenario. */
    public RigidMotion start() {
        WorldObjectDefinition of = definition(scenario, body);
        return new RigidMotion(
                of.position(), of.orientation(), of.velocity(), of.angularVelocity());
    }

    /**
     * What the body's mount leaves of a change of its motion.
     *
     * @param change position (m), turn (rad), velocity (m/s), angular velocity (rad/s), world axes
     */
    public double[] free(double[] change) {
        Optional<Mount> mount = definition(scenario, body).mount();
        if (mount.isEmpty()) {
            return change;
        }
        double[] free = new double[RigidMotion.SIZE];
        for (int part = 0; part < change.length; part += 3) {
            List<Vec3> ways =
                    part % 6 == 0 ? mount.get().freeTranslations() : mount.get().freeRotations();
            Vec3 of = new Vec3(change[part], change[part + 1], change[part + 2]);
            Vec3 left = Vec3.ZERO;
            for (Vec3 way : ways) {
                left = left.plus(way.times(of.dot(way)));
            }
            free[part] = left.x();
            free[part + 1] = left.y();
            free[part + 2] = left.z();
        }
        return free;
    }

    /**
     * The part of a change of motion by which a start may differ: any position; but where the mount
     * holds the body, its orientation and velocities stay as in the scenario.
     *
     * @param change as for {@link #free}
     */
    public double[] startable(double[] change) {
        double[] startable = free(change).clone();
        System.arraycopy(change, 0, startable, 0, 3);
        return startable;
    }

    /**
     * The possible start that is nearest to a motion as it was measured, or stated: noise about an
     * axis that the mount holds is no turn.
     */
    public RigidMotion nearestStart(RigidMotion motion) {
        if (definition(scenario, body).mount().isEmpty()) {
            return motion;
        }
        RigidMotion start = start();
        return start.plus(startable(motion.minus(start)));
    }

    /** The body as it is believed. */
    public Variant variant() {
        return new Variant(definition(scenario, body), List.of(), Sensing.EXACT);
    }

    /** Behaviors of the body that do not act in a run, as it tells what they would. */
    public List<Behavior> overruledBy(MeasuredRun run) {
        return new Inputs(run, definition(scenario, body)).overruled();
    }

    /** The same, in steps of at most so long (s). */
    public BelievedModel stepping(double longestStep) {
        return new BelievedModel(scenario.with(new TimeStep(longestStep)), body);
    }

    /** The scenario with a variant of the body and its currents: what a diagnosis has found. */
    public Scenario extended(Variant variant) {
        List<Field<?>> fields = new ArrayList<>(scenario.field());
        fields.addAll(variant.currents());
        List<WorldObjectDefinition> objects = new ArrayList<>(scenario.worldObject());
        objects.replaceAll(object -> object.name().equals(body) ? variant.body() : object);
        return scenario.with(fields, objects);
    }
}
