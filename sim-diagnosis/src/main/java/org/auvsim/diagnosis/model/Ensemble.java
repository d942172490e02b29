package org.auvsim.diagnosis.model;

import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.StepException;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.diagnosis.model.Partings.Leg;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

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

    /**
     * Motions whose steps the engine cuts into more parts on average are as good as lost: no model
     * that is near the truth moves like that.
     */
    private static final long MOST_PARTS = 32;

    /** So many steps of a body may be cut more. */
    private static final int A_MOMENT = 50;

    /** No body is so far off (m), moves (m/s) or turns (rad/s) so fast. */
    private static final double OUT_OF_ALL_BOUNDS = 1e9;

    /** A motion that gets lost is said to be cut so often. */
    private static final long TOO_MANY = 1L << 32;

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

    /** How commands hold between the samples at which motions are told. */
    public enum Commands {
        /** Each from its row to the next, as in the run. */
        FROM_ROW_TO_ROW,
        /**
         * Their mean, where they change more than once from one sample to the next: steps may then
         * be as long as that, and differences of two motions are nearly the same.
         */
        EVENED
    }

    private final MeasuredRun run;
    private final Inputs inputs;
    private final World world;
    private final List<WorldObject> bodies = new ArrayList<>();
    private final double longestStep;

    /** Whether the bodies were told the mean of some rows, and no row's command since. */
    private boolean areEvened;

    private final Commands commands;
    private final Ground ground;

    /** Of differences in long steps: whoever wants them has shorter ones where these get lost. */
    private final Optional<FewParts> fewParts;

    private long made;

    Ensemble(
            BelievedModel model,
            MeasuredRun run,
            int from,
            List<Entrant> entrants,
            double longestStep,
            Commands commands) {
        this.run = run;
        this.commands = commands;
        this.inputs = new Inputs(run, model.variant().body());
        this.longestStep = longestStep;
        WorldBuilder builder =
                World.builder().startTime(run.time(from)).timeStep(longestStep).allowOverlaps();
        ground = Ground.under(model);
        ground.addTo(builder);
        fewParts =
                commands == Commands.EVENED && model.touchesNothing()
                        ? Optional.of(new FewParts())
                        : Optional.empty();
        fewParts.ifPresent(builder::integrator);
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
                begun(entrants.get(i)).giveTo(body);
            }
        }
    }

    private RigidMotion begun(Entrant entrant) {
        return ground.beside(entrant.variant().body().volume(), entrant.start());
    }

    private static String name(int i) {
        return "variant " + i;
    }

    private WorldObjectDefinition definition(int i, Entrant entrant, int from) {
        RigidMotion start = begun(entrant);
        WorldObjectDefinition own = entrant.variant().body();
        WorldObjectDefinition.Builder body = run.differences().on(own);
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
                .components(inputs.before(from, own.component()))
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
        return simulate(model, run, IntStream.rangeClosed(from, to).toArray(), entrants);
    }

    /**
     * The same, told at some samples alone; steps may then be longer than from one sample to the
     * next.
     *
     * @param samples in order, the first and the last included
     * @return motion of each variant at each of these samples
     */
    public static RigidMotion[][] simulate(
            BelievedModel model, MeasuredRun run, int[] samples, List<Entrant> entrants) {
        return simulate(model, run, samples, entrants, Commands.FROM_ROW_TO_ROW);
    }

    /** The same under commands that may be evened out. */
    public static RigidMotion[][] simulate(
            BelievedModel model,
            MeasuredRun run,
            int[] samples,
            List<Entrant> entrants,
            Commands commands) {
        if (entrants.size() > together(model, entrants)) {
            return halves(model, run, samples, entrants, commands);
        }
        try {
            return inOneWorld(model, run, samples, entrants, commands);
        } catch (StepException e) {
            return entrants.size() == 1
                    ? lost(1, samples.length)
                    : halves(model, run, samples, entrants, commands);
        }
    }

    /**
     * The same of variants that hardly differ from the first, as those that differences are taken
     * of: if that one gets lost, all are lost, and none of them is tried alone. In long steps all
     * are lost if any is.
     */
    public static RigidMotion[][] neighbours(
            BelievedModel model,
            MeasuredRun run,
            int[] samples,
            List<Entrant> entrants,
            Commands commands) {
        try {
            return entrants.size() > together(model, entrants)
                    ? halves(model, run, samples, entrants, commands)
                    : inOneWorld(model, run, samples, entrants, commands);
        } catch (StepException e) {
            if (commands == Commands.EVENED) {
                return lost(entrants.size(), samples.length);
            }
            RigidMotion[] first =
                    simulate(model, run, samples, entrants.subList(0, 1), commands)[0];
            return first[0].equals(LOST)
                    ? lost(entrants.size(), samples.length)
                    : halves(model, run, samples, entrants, commands);
        }
    }

    /** All in one world, an entrant that is there more than once only once. */
    private static RigidMotion[][] inOneWorld(
            BelievedModel model,
            MeasuredRun run,
            int[] samples,
            List<Entrant> entrants,
            Commands commands) {
        IdentityHashMap<Entrant, Integer> numbers = new IdentityHashMap<>();
        List<Entrant> once = new ArrayList<>();
        int[] which = new int[entrants.size()];
        for (int i = 0; i < which.length; i++) {
            which[i] = numbers.computeIfAbsent(entrants.get(i), _ -> once.size());
            if (which[i] == once.size()) {
                once.add(entrants.get(i));
            }
        }
        double step = model.scenario().timeStep().delta();
        RigidMotion[][] motions =
                new Ensemble(model, run, samples[0], once, step, commands).simulate(samples);
        return Arrays.stream(which).mapToObj(i -> motions[i]).toArray(RigidMotion[][]::new);
    }

    /**
     * What motions take.
     *
     * @param steps how many
     * @param cuts how many more the engine makes of steps that are too long for stiff forces
     */
    public record Work(long steps, long cuts) {
        /** That of no motion. */
        public static final Work NONE = new Work(0, 0);

        /** Both together. */
        public Work plus(Work other) {
            return new Work(steps + other.steps, cuts + other.cuts);
        }

        /** Steps, and parts of those that are cut. */
        public long parts() {
            return steps + cuts;
        }
    }

    /**
     * What a variant's motion takes.
     *
     * @param samples between which it is simulated, in order
     */
    public static Work work(
            BelievedModel model,
            MeasuredRun run,
            int[] samples,
            Entrant entrant,
            Commands commands) {
        double step = model.scenario().timeStep().delta();
        Ensemble alone = new Ensemble(model, run, samples[0], List.of(entrant), step, commands);
        try {
            alone.simulate(samples);
        } catch (StepException e) {
            return new Work(alone.made, TOO_MANY);
        }
        return new Work(alone.made, alone.world.statistics().subSteps());
    }

    /** How many may share a world; every body asks all currents whether it feels them. */
    static int together(BelievedModel model, List<Entrant> entrants) {
        int most = Ground.under(model).together(entrants.size());
        boolean inOwnWater = entrants.stream().anyMatch(e -> !e.variant().currents().isEmpty());
        return inOwnWater ? Math.min(most, MOST_IN_OWN_WATER) : most;
    }

    private RigidMotion[][] simulate(int[] samples) {
        RigidMotion[][] motions = new RigidMotion[bodies.size()][samples.length];
        keep(motions, 0);
        for (int s = 1; s < samples.length; s++) {
            advance(samples[s - 1], samples[s], s == 1);
            keep(motions, s);
        }
        return motions;
    }

    /** From one sample to another, with what is commanded between them. */
    private void advance(int from, int to, boolean areNew) {
        if (commands == Commands.EVENED && inputs.changes(from, to) > 1) {
            inputs.commandMean(from, to, world.time(), bodies);
            areEvened = true;
            advance(run.time(to));
            return;
        }
        for (int k = from; k < to; k++) {
            inputs.command(k, areEvened || (areNew && k == from), world.time(), bodies);
            areEvened = false;
            if (k + 1 == to || inputs.changeAt(k + 1)) {
                advance(run.time(k + 1));
            }
        }
    }

    /** So many motions that got lost, at so many samples. */
    public static RigidMotion[][] lost(int motions, int samples) {
        RigidMotion[] motion = new RigidMotion[samples];
        Arrays.fill(motion, LOST);
        RigidMotion[][] lost = new RigidMotion[motions][];
        Arrays.fill(lost, motion);
        return lost;
    }

    /** In two worlds: one that cannot be simulated takes none of the others with it. */
    private static RigidMotion[][] halves(
            BelievedModel model,
            MeasuredRun run,
            int[] samples,
            List<Entrant> entrants,
            Commands commands) {
        int half = entrants.size() / 2;
        RigidMotion[][] first = simulate(model, run, samples, entrants.subList(0, half), commands);
        RigidMotion[][] second =
                simulate(model, run, samples, entrants.subList(half, entrants.size()), commands);
        RigidMotion[][] all = Arrays.copyOf(first, entrants.size());
        System.arraycopy(second, 0, all, half, second.length);
        return all;
    }

    /**
     * By how much the others part from the first body in legs that follow one another.
     *
     * @return by body and leg
     */
    double[][][] part(List<Leg> legs) {
        double[][][] partings = new double[bodies.size() - 1][legs.size()][];
        for (int l = 0; l < legs.size(); l++) {
            Leg leg = legs.get(l);
            bodies.forEach(leg.start()::giveTo);
            advance(leg.from(), leg.to(), l == 0);
            RigidMotion end = motion(0);
            for (int i = 0; i < partings.length; i++) {
                partings[i][l] = motion(i + 1).minus(end);
            }
        }
        return partings;
    }

    private void keep(RigidMotion[][] motions, int sample) {
        for (int i = 0; i < motions.length; i++) {
            motions[i][sample] = motion(i);
        }
    }

    /**
     * How a body moves.
     *
     * @throws StepException if it is where nothing can be: squares and products of what is still
     *     finite then are not
     */
    private RigidMotion motion(int body) {
        RigidMotion motion = RigidMotion.of(bodies.get(body));
        double largest =
                Math.max(
                        motion.position().norm(),
                        Math.max(motion.velocity().norm(), motion.angularVelocity().norm()));
        if (!(largest < OUT_OF_ALL_BOUNDS)) {
            throw new StepException("a motion gets out of all bounds");
        }
        return motion;
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
            double step = (until - world.time()) / s;
            fewParts.ifPresent(of -> of.of(step));
            world.advanceTimestep(step);
            made += bodies.size();
        }
        if (world.statistics().subSteps() > MOST_PARTS * (made + A_MOMENT)) {
            throw new StepException(
                    "steps of %s s are cut into far too many parts".formatted(longestStep));
        }
    }
}
