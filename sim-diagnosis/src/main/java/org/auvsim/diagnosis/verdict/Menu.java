package org.auvsim.diagnosis.verdict;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Knowledge;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.NextExperiment;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownDifferences;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.search.Told;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Proposes the run of a menu that would tell most among models that are left: the one of which most
 * others would miss something if the best is true, and miss most, in units of the noise. Its start
 * would be known as well as those of the runs were; what another start explains tells nothing.
 */
final class Menu {
    private static final int SAMPLES = 200;
    private static final int AXES = 3;

    /** Steps from new starts. */
    private static final int STEPS = 12;

    /** As long as the longest of the runs, but not more (s). */
    private static final double LONGEST = 30;

    private static final double LEVEL = 0.7;
    private static final double SPIN = 0.5;
    private static final double SHARE_OF_MASS = 0.2;

    /** Logarithm of odds from which evidence is strong (Kass and Raftery 1995). */
    private static final double STRONG = 3;

    private static final double ROUNDING = 1e-9;

    /** Where a body lies upon something it may be said to begin so far within it (m). */
    private static final double WITHIN = 1e-3;

    /** So much lower is another depth (m). */
    private static final double DEEPER = 5;

    private final Stepping stepping;
    private final List<MeasuredRun> runs;
    private final MeasuredRun first;
    private final Noise noise;
    private final double duration;
    private final RigidMotion rest;
    private final Optional<List<Double>> startDeviations;

    /** For a body that was measured so; its experiments begin where the first run did. */
    Menu(Fit fit, Noise noise) {
        this.stepping = fit.stepping().idle();
        this.runs = fit.data().stream().map(Misses::run).toList();
        this.first = fit.data().getFirst().run();
        this.noise = noise;
        double longest = 0;
        for (Misses of : fit.data()) {
            longest = Math.max(longest, of.run().duration());
        }
        this.duration = Math.min(LONGEST, longest);
        RigidMotion start = fit.windows().getFirst().getFirst().start();
        this.rest =
                stepping.model()
                        .beside(
                                new RigidMotion(
                                        start.position(),
                                        start.orientation(),
                                        Vec3.ZERO,
                                        Vec3.ZERO));
        this.startDeviations =
                fit.data().stream()
                        .flatMap(of -> of.run().start().stream())
                        .map(KnownStart::deviations)
                        .findFirst();
    }

    /**
     * An experiment.
     *
     * @param driven names of the propulsors that are
     */
    private record Dish(
            String id,
            String description,
            List<String> driven,
            KnownDifferences differences,
            RigidMotion start) {}

    /** What tells the best from its competitors; empty if there are none, or nothing does. */
    Optional<NextExperiment> next(Judged best, List<Judged> competitors) {
        return competitors.isEmpty()
                ? Optional.empty()
                : dishes().stream()
                        .filter(this::isPossible)
                        .map(dish -> experiment(dish, best, competitors))
                        .flatMap(Optional::stream)
                        .max(
                                Comparator.comparingInt(Told::competitors)
                                        .thenComparingDouble(told -> told.experiment().evidence()))
                        .map(Told::experiment);
    }

    /** An experiment, and how many competitors it tells from the best. */
    private record Told(NextExperiment experiment, int competitors) {}

    /** Whether it begins otherwise only where nothing holds the body, nor is in its way. */
    private boolean isPossible(Dish dish) {
        return isFree(dish) && isOutside(dish.start());
    }

    private boolean isOutside(RigidMotion start) {
        RigidMotion beside = stepping.model().beside(start);
        return beside.position().distance(start.position()) < WITHIN;
    }

    private boolean isFree(Dish dish) {
        double[] moved = dish.start().minus(rest);
        double[] free = stepping.model().free(moved);
        return IntStream.range(0, moved.length)
                .allMatch(i -> Math.abs(moved[i] - free[i]) < ROUNDING);
    }

    /** Empty if it tells the best from no competitor. */
    private Optional<Told> experiment(Dish dish, Judged best, List<Judged> competitors) {
        MeasuredRun run = measured(dish, best.fit().hypothesis().in(stepping.variant()));
        List<Cause> causes = best.fit().hypothesis().causes();
        double least = Double.POSITIVE_INFINITY;
        int told = 0;
        Set<String> separates = new LinkedHashSet<>();
        for (Judged competitor : competitors) {
            Hypothesis of = competitor.fit().hypothesis();
            double evidence = evidence(run, dish.start(), of);
            if (evidence > STRONG) {
                Set<Cause> either = new LinkedHashSet<>(causes);
                either.addAll(of.causes());
                either.stream()
                        .filter(c -> !causes.contains(c) || !of.causes().contains(c))
                        .forEach(cause -> separates.add(cause.label()));
                least = Math.min(least, evidence);
                told++;
            }
        }
        return told == 0
                ? Optional.empty()
                : Optional.of(
                        new Told(
                                new NextExperiment(
                                        dish.id(),
                                        String.format(
                                                Locale.ROOT,
                                                "%s, for %.3g s",
                                                dish.description(),
                                                duration),
                                        List.copyOf(separates),
                                        least),
                                told));
    }

    /**
     * Half of what a hypothesis misses of it, from the start that suits it after a few steps, which
     * one would not find where drag is quadratic; where that is much, from new starts, too, as that
     * of a body which nothing steadies is hard to find. 0 if it gets lost.
     */
    private double evidence(MeasuredRun run, RigidMotion start, Hypothesis of) {
        List<Window> whole = List.of(new Window(0, run.size() - 1, start));
        List<Misses> data = List.of(new Misses(run, noise));
        Fit fit = new Fit(stepping, data, of.settled(), List.of(whole), Knowledge.NONE);
        double missed = Refinement.approach(fit, 1).cost();
        if (missed > 2 * STRONG && isPlaceTold()) {
            Fit begun = Following.anew(fit, noise, Course.UNHEARD);
            missed =
                    Math.min(missed, Descent.of(Refinement.approach(begun, 1)).steps(STEPS).cost());
        }
        return Double.isFinite(missed) ? missed / 2 : 0;
    }

    /** If not, where it starts is known only as the experiment has it. */
    private boolean isPlaceTold() {
        return IntStream.range(0, AXES).allMatch(axis -> tells(Channel.POSITION, axis));
    }

    /** As the sensors would tell it, without noise, if this were true. */
    private MeasuredRun measured(Dish dish, Variant truth) {
        MeasuredRunBuilder planned = begun(dish);
        for (int k = 0; k <= SAMPLES; k++) {
            at(k, dish, planned);
        }
        MeasuredRun plan = planned.build();
        List<Entrant> alone = List.of(new Entrant(truth, dish.start()));
        RigidMotion[] motion =
                Ensemble.simulate(stepping.model(), plan, 0, plan.size() - 1, alone)[0];
        if (motion[0].equals(Ensemble.LOST)) {
            return plan;
        }
        RigidMotion[] told = truth.sensing().of(motion, plan, 0, plan.size());
        MeasuredRunBuilder run = begun(dish);
        startDeviations.ifPresent(d -> run.start(new KnownStart(dish.start(), d)));
        for (int k = 0; k < told.length; k++) {
            at(k, dish, run);
            Vec3 place = told[k].position();
            run.position(
                    tells(Channel.POSITION, 0) ? place.x() : Double.NaN,
                    tells(Channel.POSITION, 1) ? place.y() : Double.NaN,
                    tells(Channel.POSITION, 2) ? place.z() : Double.NaN);
            run.orientation(
                    told[k].orientation(),
                    tells(Channel.ORIENTATION, 0),
                    tells(Channel.ORIENTATION, 1),
                    tells(Channel.ORIENTATION, 2));
            tell(Channel.VELOCITY, told[k].velocity(), told[k].orientation(), run);
            tell(Channel.ANGULAR_VELOCITY, told[k].angularVelocity(), told[k].orientation(), run);
        }
        return run.build();
    }

    /** In the axes in which the runs have it. */
    private void tell(Channel channel, Vec3 world, Quat orientation, MeasuredRunBuilder run) {
        Vec3 told = frame(channel) == Frame.BODY ? orientation.rotateInverse(world) : world;
        run.measured(
                channel,
                tells(channel, 0) ? told.x() : Double.NaN,
                tells(channel, 1) ? told.y() : Double.NaN,
                tells(channel, 2) ? told.z() : Double.NaN);
    }

    private Frame frame(Channel channel) {
        return runs.stream()
                .filter(run -> run.measures(channel))
                .findFirst()
                .orElse(first)
                .frame(channel);
    }

    private boolean tells(Channel channel, int axis) {
        return noise.tells(channel, axis);
    }

    /** Its sensors err as lastingly as those of the first run did. */
    private MeasuredRunBuilder begun(Dish dish) {
        MeasuredRunBuilder run =
                MeasuredRun.named(dish.id())
                        .commands(commands(dish))
                        .differences(dish.differences());
        for (Channel channel : Channel.values()) {
            run.frame(channel, frame(channel));
            for (int axis = 0; axis < AXES; axis++) {
                for (LastingError error : first.lastingErrors(channel, axis)) {
                    run.lastingError(channel, axis, error);
                }
            }
        }
        return run;
    }

    /** What is driven, and then all that the runs commanded, which is told to do nothing. */
    private List<String> commands(Dish dish) {
        Set<String> commands = new LinkedHashSet<>(dish.driven());
        runs.forEach(run -> run.commands().forEach(command -> commands.add(command.name())));
        return List.copyOf(commands);
    }

    /** A sample, with what is commanded from it on. */
    private void at(int sample, Dish dish, MeasuredRunBuilder run) {
        // What began in the runs has begun.
        run.at(first.time(0) + duration * sample / SAMPLES);
        for (int c = 0; c < dish.driven().size(); c++) {
            run.command(c, LEVEL);
        }
    }

    private List<Dish> dishes() {
        List<Dish> dishes = new ArrayList<>();
        dishes.add(plain("drop", "let it go from rest, nothing driven", List.of(), rest));
        dishes.add(
                plain(
                        "coast_down",
                        "give it 1 m/s ahead, then drive nothing",
                        List.of(),
                        moving(rest.orientation().rotate(new Vec3(1, 0, 0)), Vec3.ZERO)));
        dishes.add(
                plain(
                        "spin_up",
                        "turn it at %s rad/s about the vertical, then drive nothing"
                                .formatted(SPIN),
                        List.of(),
                        moving(Vec3.ZERO, new Vec3(0, 0, SPIN))));
        Variant believed = stepping.variant();
        List<String> propulsors =
                believed.body().component().stream()
                        .filter(Propulsor.class::isInstance)
                        .map(component -> component.name())
                        .toList();
        for (String name : propulsors) {
            dishes.add(
                    plain(
                            "one_thruster",
                            "drive '%s' alone at %s from rest".formatted(name, LEVEL),
                            List.of(name),
                            rest));
        }
        if (!propulsors.isEmpty()) {
            dishes.add(
                    plain(
                            "another_heading",
                            "drive all at %s from rest, turned by 90 degrees".formatted(LEVEL),
                            propulsors,
                            turned()));
            dishes.add(
                    plain(
                            "another_depth",
                            "drive all at %s from rest, %s m deeper".formatted(LEVEL, DEEPER),
                            propulsors,
                            deeper()));
        }
        double mass = SHARE_OF_MASS * believed.body().mass().orElse(0.0);
        if (mass > 0) {
            dishes.add(
                    new Dish(
                            "known_mass",
                            String.format(
                                    Locale.ROOT,
                                    "%s with %.3g kg more, tightly fixed",
                                    propulsors.isEmpty()
                                            ? "let it go from rest"
                                            : "drive all at %s from rest".formatted(LEVEL),
                                    mass),
                            propulsors,
                            new KnownDifferences(mass, List.of(), List.of()),
                            rest));
        }
        return dishes;
    }

    private static Dish plain(String id, String text, List<String> driven, RigidMotion start) {
        return new Dish(id, text, driven, KnownDifferences.NONE, start);
    }

    private RigidMotion moving(Vec3 velocity, Vec3 angular) {
        return new RigidMotion(rest.position(), rest.orientation(), velocity, angular);
    }

    private RigidMotion deeper() {
        return new RigidMotion(
                rest.position().plus(new Vec3(0, 0, -DEEPER)),
                rest.orientation(),
                Vec3.ZERO,
                Vec3.ZERO);
    }

    private RigidMotion turned() {
        Quat quarter = new Quat(Math.sqrt(0.5), 0, 0, Math.sqrt(0.5));
        return new RigidMotion(
                rest.position(), quarter.times(rest.orientation()), Vec3.ZERO, Vec3.ZERO);
    }
}
