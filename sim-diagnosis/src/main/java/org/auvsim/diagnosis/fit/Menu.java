package org.auvsim.diagnosis.fit;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.result.NextExperiment;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownDifferences;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Proposes the run of a menu that would tell most among models that are left: the one whose
 * predictions differ most, in units of the noise.
 */
final class Menu {
    private static final int SAMPLES = 200;

    /** As long as the longest of the runs, but not more (s). */
    private static final double LONGEST = 30;

    private static final double LEVEL = 0.7;
    private static final double SPIN = 0.5;
    private static final double SHARE_OF_MASS = 0.2;

    private final BelievedModel model;
    private final Noise noise;
    private final double duration;
    private final RigidMotion rest;

    /** For a body that was measured so; its experiments begin where the first run did. */
    Menu(BelievedModel model, Fit fit, Noise noise) {
        this.model = model;
        this.noise = noise;
        double longest = 0;
        for (Misses of : fit.data()) {
            longest = Math.max(longest, of.run().duration());
        }
        this.duration = Math.min(LONGEST, longest);
        RigidMotion start = fit.windows().getFirst().getFirst().start();
        this.rest = new RigidMotion(start.position(), start.orientation(), Vec3.ZERO, Vec3.ZERO);
    }

    private record Dish(String id, String description, MeasuredRun run, RigidMotion start) {}

    /** What tells the best from its competitors; empty if there are none, or nothing does. */
    Optional<NextExperiment> next(Judged best, List<Judged> competitors) {
        return dishes().stream()
                .map(dish -> experiment(dish, best, competitors))
                .filter(experiment -> experiment.evidence() > 1)
                .max(Comparator.comparingDouble(NextExperiment::evidence));
    }

    private NextExperiment experiment(Dish dish, Judged best, List<Judged> competitors) {
        List<Entrant> entrants = new ArrayList<>();
        entrants.add(new Entrant(best.fit().variant(), dish.start()));
        competitors.forEach(c -> entrants.add(new Entrant(c.fit().variant(), dish.start())));
        RigidMotion[][] motions =
                Ensemble.simulate(model, dish.run(), 0, dish.run().size() - 1, entrants);
        double least = Double.POSITIVE_INFINITY;
        List<String> separates = new ArrayList<>();
        for (int i = 1; i < entrants.size(); i++) {
            double evidence = evidence(dish.run(), entrants, motions, i);
            if (evidence > 1) {
                separates.addAll(
                        competitors.get(i - 1).fit().hypothesis().causes().stream()
                                .map(cause -> cause.name())
                                .filter(name -> !separates.contains(name))
                                .toList());
            }
            least = Math.min(least, evidence);
        }
        return new NextExperiment(
                dish.id(),
                dish.description(),
                separates,
                entrants.size() > 1 && Double.isFinite(least) ? least : 0);
    }

    /** Half the squared difference of what sensors would tell, in standard deviations. */
    private double evidence(
            MeasuredRun run, List<Entrant> entrants, RigidMotion[][] motions, int other) {
        double sum = 0;
        RigidMotion[] one = told(entrants.getFirst(), motions[0], run);
        RigidMotion[] another = told(entrants.get(other), motions[other], run);
        for (int k = 0; k < run.size(); k++) {
            double[] off = one[k].minus(another[k]);
            for (int i = 0; i < 6; i++) {
                Channel channel = i < 3 ? Channel.POSITION : Channel.ORIENTATION;
                if (noise.tells(channel, i % 3)) {
                    sum += Math.pow(off[i] / noise.of(channel, i % 3), 2);
                }
            }
        }
        return sum / 2;
    }

    private static RigidMotion[] told(Entrant entrant, RigidMotion[] motion, MeasuredRun run) {
        return entrant.variant().sensing().of(motion, run, 0, run.size());
    }

    private List<Dish> dishes() {
        List<Dish> dishes = new ArrayList<>();
        dishes.add(new Dish("drop", "let it go from rest, nothing driven", run(List.of()), rest));
        dishes.add(
                new Dish(
                        "coast_down",
                        "give it 1 m/s ahead, then drive nothing",
                        run(List.of()),
                        moving(rest.orientation().rotate(new Vec3(1, 0, 0)), Vec3.ZERO)));
        dishes.add(
                new Dish(
                        "spin_up",
                        "turn it at %s rad/s about the vertical, then drive nothing"
                                .formatted(SPIN),
                        run(List.of()),
                        moving(Vec3.ZERO, new Vec3(0, 0, SPIN))));
        List<String> propulsors =
                model.variant().body().component().stream()
                        .filter(Propulsor.class::isInstance)
                        .map(component -> component.name())
                        .toList();
        for (String name : propulsors) {
            dishes.add(
                    new Dish(
                            "one_thruster",
                            "drive '%s' alone at %s from rest".formatted(name, LEVEL),
                            run(List.of(name)),
                            rest));
        }
        if (!propulsors.isEmpty()) {
            dishes.add(
                    new Dish(
                            "another_heading",
                            "drive all at %s from rest, turned by 90 degrees".formatted(LEVEL),
                            run(propulsors),
                            turned()));
        }
        double mass = SHARE_OF_MASS * model.variant().body().mass().orElse(0.0);
        if (mass > 0) {
            dishes.add(
                    new Dish(
                            "known_mass",
                            "repeat a run with %.3g kg more, tightly fixed".formatted(mass),
                            named("known_mass", propulsors)
                                    .differences(new KnownDifferences(mass, List.of(), List.of()))
                                    .build(),
                            rest));
        }
        return dishes;
    }

    private RigidMotion moving(Vec3 velocity, Vec3 angular) {
        return new RigidMotion(rest.position(), rest.orientation(), velocity, angular);
    }

    private RigidMotion turned() {
        Quat quarter = new Quat(Math.sqrt(0.5), 0, 0, Math.sqrt(0.5));
        return new RigidMotion(
                rest.position(), quarter.times(rest.orientation()), Vec3.ZERO, Vec3.ZERO);
    }

    private MeasuredRun run(List<String> driven) {
        return named("experiment", driven).build();
    }

    private MeasuredRunBuilder named(String name, List<String> driven) {
        MeasuredRunBuilder run = MeasuredRun.named(name).commands(driven);
        for (int k = 0; k <= SAMPLES; k++) {
            run.at(duration * k / SAMPLES);
            for (int c = 0; c < driven.size(); c++) {
                run.command(c, LEVEL);
            }
        }
        return run;
    }
}
