package org.auvsim.experiments.hidden;

import org.auvsim.experiments.hidden.Effects.Kind;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Draws cases: the same seed gives the same case, at another noise the same but for the noise. */
public final class CaseBook {
    private static final int RUNS = 5;
    private static final double WEAK = 0.3;

    /** Share of its range by which an effect changes the motion. */
    private static final double LEAST_SHARE = 0.05;

    private static final double MOST_SHARE = 0.5;
    private static final double HEAVY_TAILED = 1.0 / 3;

    private CaseBook() {}

    /** A case of a kind. */
    public static HiddenCase draw(CaseKind kind, double noise, long seed) {
        Draws draws = new Draws(seed * 31 + kind.number());
        Optional<Puzzle> puzzle =
                kind == CaseKind.ALIAS ? Optional.of(Puzzle.draw(draws)) : Optional.empty();
        Body body = puzzle.map(Puzzle::body).orElseGet(() -> draws.oneOf(Body.ALL));
        while (true) {
            Optional<HiddenCase> drawn = attempt(kind, noise, seed, body, puzzle, draws.split());
            if (drawn.isPresent()) {
                return drawn.get();
            }
        }
    }

    private static Optional<HiddenCase> attempt(
            CaseKind kind,
            double noise,
            long seed,
            Body body,
            Optional<Puzzle> puzzle,
            Draws draws) {
        Plant plant = body.plant(draws.split());
        boolean shows = body.showsOrientation(draws.split());
        List<Manoeuvre> manoeuvres = new ArrayList<>();
        List<Long> luck = new ArrayList<>();
        for (int r = 0; r < RUNS; r++) {
            manoeuvres.add(body.manoeuvre(draws.split()));
            luck.add(draws.seed());
        }
        Trial trial = new Trial(manoeuvres, luck);
        Optional<List<List<Pose>>> believed = trial.poses(Reality.of(plant));
        if (believed.isEmpty()) {
            return Optional.empty();
        }
        Scene scene = Scene.of(plant, shows, believed.get(), manoeuvres);
        List<HiddenEffect> hidden =
                puzzle.map(p -> List.of(p.hidden()))
                        .orElseGet(
                                () ->
                                        effects(
                                                kind,
                                                strength(scene, trial, believed.get()),
                                                draws.split()));
        if (hidden.size() < wanted(kind)) {
            return Optional.empty();
        }
        boolean isHeavyTailed = kind == CaseKind.NULL && draws.chance(HEAVY_TAILED);
        return CaseRuns.measured(
                        scene,
                        trial,
                        hidden,
                        noise,
                        isHeavyTailed,
                        puzzle.map(Puzzle::looseness).orElse(1.0),
                        draws.split())
                .map(
                        runs ->
                                new HiddenCase(
                                        new HiddenCase.Drawn(kind, noise, seed, body.name()),
                                        hidden,
                                        puzzle.map(Puzzle::twins),
                                        ScenarioText.of(plant, body.timeStep()),
                                        runs,
                                        scene));
    }

    /** Told by the fit runs alone. */
    private static Strength strength(Scene scene, Trial trial, List<List<Pose>> believed) {
        return new Strength(
                scene,
                new Trial(
                        trial.manoeuvres().subList(0, CaseRuns.FIT),
                        trial.seeds().subList(0, CaseRuns.FIT)),
                believed.subList(0, CaseRuns.FIT));
    }

    private static int wanted(CaseKind kind) {
        return switch (kind) {
            case NULL -> 0;
            case PAIR -> 2;
            default -> 1;
        };
    }

    private static List<HiddenEffect> effects(CaseKind kind, Strength strength, Draws draws) {
        List<Kind> kinds =
                kind == CaseKind.UNCOVERED
                        ? Effects.UNCOVERED
                        : List.copyOf(Effects.LIBRARY.values());
        List<HiddenEffect> effects = new ArrayList<>();
        while (effects.size() < wanted(kind)) {
            Kind of = draws.oneOf(kinds);
            double share = draws.logBetween(LEAST_SHARE, MOST_SHARE);
            if (!of.fits().test(strength.scene())) {
                continue;
            }
            Family family = of.family().apply(strength.scene(), draws.split());
            OptionalDouble found = strength.of(family, share);
            if (found.isEmpty()) {
                return List.of();
            }
            double factor = kind == CaseKind.WEAK ? WEAK : 1;
            HiddenEffect effect = family.of().apply(factor * found.getAsDouble());
            if (effects.stream().noneMatch(e -> e.cause().equals(effect.cause()))) {
                effects.add(effect);
            }
        }
        return effects;
    }
}
