package org.auvsim.diagnosis.model;

import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.StepException;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.diagnosis.run.KnownDifferences;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Variants of one body in the model's world, each as if it were alone, side by side through a part
 * of a measured run: by the engine's own step, many bodies at a time.
 */
public final class Ensemble {
    /** Share of a step by which times may be off that mean the same. */
    private static final double ROUNDING = 1e-6;

    /** Variants have ids beyond those of the scenario. */
    private static final long FIRST_ID = 1_000_000_000L;

    private static final int MOST_IN_OWN_WATER = 64;

    private static final Vec3 NOWHERE = new Vec3(Double.NaN, Double.NaN, Double.NaN);

    /** A motion of which nothing can be said: all NaN. */
    public static final RigidMotion LOST =
            new RigidMotion(
                    NOWHERE,
                    new Quat(Double.NaN, Double.NaN, Double.NaN, Double.NaN),
                    NOWHERE,
                    NOWHERE);

    /**
     * A variant and how it moves at the beginning.
     *
     * @param start at the first sample of the part
     */
    public record Entrant(Variant variant, RigidMotion start) {}

    private final MeasuredRun run;
    private final Inputs inputs;
    private final World world;
    private final List<WorldObject> bodies = new ArrayList<>();
    private final double longestStep;
    private final Ground ground;

    private Ensemble(BelievedModel model, MeasuredRun run, int from, List<Entrant> entrants) {
        this.run = run;
        this.inputs = new Inputs(run, model.variant().body());
        this.longestStep = model.scenario().timeStep().delta();
        WorldBuilder builder =
                World.builder().startTime(run.time(from)).timeStep(longestStep).allowOverlaps();
        ground = Ground.under(model);
        ground.addTo(builder);
        model.scenario().field().forEach(builder::add);
        run.differences().currents().forEach(builder::add);
        for (int i = 0; i < entrants.size(); i++) {
            builder.add(definition(i, entrants.get(i), from));
        }
        world = builder.build();
        long id = world.entities().stream().mapToLong(e -> e.id()).max().orElse(0);
        for (int i = 0; i < entrants.size(); i++) {
            WorldObject body = world.object(name(i));
            bodies.add(body);
            for (Current current : entrants.get(i).variant().currents()) {
                id++;
                world.add(new CurrentOfOne(id, "own " + id, current.prepared(), body.slot()));
            }
            if (!entrants.get(i).variant().currents().isEmpty()) {
                // Its momenta were those of that velocity in other water.
                entrants.get(i).start().giveTo(body);
            }
        }
    }

    private static String name(int i) {
        return "variant " + i;
    }

    private WorldObjectDefinition definition(int i, Entrant entrant, int from) {
        RigidMotion start = entrant.start();
        WorldObjectDefinition.Builder body = entrant.variant().body().toBuilder();
        KnownDifferences known = run.differences();
        known.effects().forEach(body::effect);
        if (known.mass() != 0) {
            body.mass(entrant.variant().body().mass().orElseThrow() + known.mass());
        }
        return ground.touching(body)
                .id(FIRST_ID + i)
                .renamed(name(i))
                .position(start.position())
                .orientation(start.orientation())
                .velocity(start.velocity().x(), start.velocity().y(), start.velocity().z())
                .angularVelocity(
                        start.angularVelocity().x(),
                        start.angularVelocity().y(),
                        start.angularVelocity().z())
                .components(inputs.before(from, entrant.variant().body().component()))
                .build();
    }

    /**
     * Simulates variants from one sample of a run to another.
     *
     * @return motion of each variant at each sample, the first and the last included; {@link #LOST}
     *     of a variant whose motion gets out of all bounds
     */
    public static RigidMotion[][] simulate(
            BelievedModel model, MeasuredRun run, int from, int to, List<Entrant> entrants) {
        if (entrants.size() > together(model, entrants)) {
            return halves(model, run, from, to, entrants);
        }
        try {
            return new Ensemble(model, run, from, entrants).simulate(from, to);
        } catch (StepException e) {
            return entrants.size() == 1
                    ? lost(to - from + 1)
                    : halves(model, run, from, to, entrants);
        }
    }

    /** How many may share a world; every body asks all currents whether it feels them. */
    private static int together(BelievedModel model, List<Entrant> entrants) {
        int most = Ground.under(model).together(entrants.size());
        boolean inOwnWater = entrants.stream().anyMatch(e -> !e.variant().currents().isEmpty());
        return inOwnWater ? Math.min(most, MOST_IN_OWN_WATER) : most;
    }

    private RigidMotion[][] simulate(int from, int to) {
        RigidMotion[][] motions = new RigidMotion[bodies.size()][to - from + 1];
        keep(motions, 0);
        for (int k = from; k < to; k++) {
            inputs.command(k, k == from, bodies);
            advance(run.time(k + 1));
            keep(motions, k + 1 - from);
        }
        return motions;
    }

    private static RigidMotion[][] lost(int samples) {
        RigidMotion[] motion = new RigidMotion[samples];
        Arrays.fill(motion, LOST);
        return new RigidMotion[][] {motion};
    }

    /** In two worlds: one that cannot be simulated takes none of the others with it. */
    private static RigidMotion[][] halves(
            BelievedModel model, MeasuredRun run, int from, int to, List<Entrant> entrants) {
        int half = entrants.size() / 2;
        RigidMotion[][] first = simulate(model, run, from, to, entrants.subList(0, half));
        RigidMotion[][] second =
                simulate(model, run, from, to, entrants.subList(half, entrants.size()));
        RigidMotion[][] all = Arrays.copyOf(first, entrants.size());
        System.arraycopy(second, 0, all, half, second.length);
        return all;
    }

    private void keep(RigidMotion[][] motions, int sample) {
        for (int i = 0; i < motions.length; i++) {
            motions[i][sample] = RigidMotion.of(bodies.get(i));
        }
    }

    private void advance(double until) {
        double rounding = ROUNDING * longestStep;
        while (world.time() < until - rounding) {
            inputs.schedule(world.time(), rounding, bodies);
            step(inputs.nextChange(world.time(), rounding, until));
        }
    }

    private void step(double until) {
        double span = until - world.time();
        int steps = Math.max(1, (int) Math.ceil(span / longestStep - ROUNDING));
        for (int s = steps; s > 0; s--) {
            world.advanceTimestep((until - world.time()) / s);
        }
    }
}
