package org.auvsim.diagnosis.shooting;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Ensemble.Work;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Simulates windows of a run under a variant of the model, and finds by differences how what they
 * miss, and their ends, depend on their starts and on parameters of causes: one simulation each,
 * all side by side, in steps that may be longer than those of the motion itself (Bock 1981).
 */
public record Shooting(Stepping stepping, Variant variant, Misses of) {
    /** Changes of a start: position (m), turn (rad), velocity (m/s), angular velocity (rad/s). */
    private static final double[] STEPS = {1e-5, 1e-6, 1e-6, 1e-6};

    /** In steps that do for the variant. */
    public Shooting {
        stepping = stepping.of(variant);
    }

    /** By how much a number of a start is changed. */
    static double step(int number) {
        return STEPS[number / 3];
    }

    /** The motion in a window, from its start to that of the next. */
    public RigidMotion[] motion(Window window) {
        List<Entrant> alone = List.of(new Entrant(variant, window.start()));
        if (!stepping.passesBy()) {
            return Ensemble.simulate(stepping.model(), of.run(), window.from(), window.to(), alone)[
                    0];
        }
        Knots knots = Knots.atEachCommand(of.run(), window, step(stepping.model()));
        return knots.filled(
                Ensemble.simulate(stepping.model(), of.run(), knots.samples(), alone)[0]);
    }

    /** What a motion in a window misses of its samples. */
    public double[] misses(Window window, RigidMotion[] motion) {
        return of.of(motion, variant.sensing(), window.from(), window.samples(of.run()));
    }

    /**
     * The derivatives of a window.
     *
     * @param group how many samples are taken together
     */
    public WindowDerivatives derivatives(Window window, int group, Moves moves) {
        return derivatives(window, motion(window), group, moves);
    }

    /**
     * The same where its motion is known: by shorter steps if it gets lost in longer ones alone.
     */
    public WindowDerivatives derivatives(
            Window window, RigidMotion[] motion, int group, Moves moves) {
        List<Entrant> entrants = entrants(window, moves);
        Knots knots = knots(window);
        RigidMotion[][] rough =
                isLost(motion)
                        ? Ensemble.lost(entrants.size(), knots.samples().length)
                        : Ensemble.neighbours(
                                stepping.rough(),
                                of.run(),
                                knots.samples(),
                                entrants,
                                stepping.commands());
        boolean isRough = !stepping.rough().equals(stepping.fine());
        if (isRough && isLost(rough[0]) && !isLost(motion)) {
            return new Shooting(Stepping.exact(stepping.fine()), variant, of)
                    .derivatives(window, motion, group, moves);
        }
        double[] missed = misses(window, entrants.getFirst(), motion, group);
        RigidMotion end = motion[window.length()];
        double[][] slopes = new double[rough.length - 1][];
        double[][] endSlopes = new double[rough.length - 1][];
        for (int i = 0; i < slopes.length; i++) {
            int parameter = i - RigidMotion.SIZE;
            double step = parameter < 0 ? step(i) : moves.steps().get(parameter);
            RigidMotion[] moved = knots.parted(motion, rough[0], rough[i + 1]);
            slopes[i] = slope(misses(window, entrants.get(i + 1), moved, group), missed, step);
            endSlopes[i] = slope(moved[window.length()].minus(end), step);
        }
        return new WindowDerivatives(window, motion, missed, slopes, endSlopes);
    }

    private static boolean isLost(RigidMotion[] motion) {
        return motion[0].equals(Ensemble.LOST);
    }

    /** The motion in a window as the steps of differences have it. */
    public RigidMotion[] rough(Window window, RigidMotion[] motion) {
        List<Entrant> alone = List.of(new Entrant(variant, window.start()));
        Knots knots = knots(window);
        RigidMotion[] rough =
                Ensemble.simulate(
                        stepping.rough(), of.run(), knots.samples(), alone, stepping.commands())[0];
        return knots.parted(motion, knots.of(motion), rough);
    }

    /** What a window takes in steps of differences. */
    public Work work(Window window) {
        Entrant alone = new Entrant(variant, window.start());
        double apart = stepping.rough().equals(stepping.fine()) ? 0 : step(stepping.rough());
        int[] samples = Knots.of(of.run(), window, apart).samples();
        return Ensemble.work(stepping.rough(), of.run(), samples, alone, stepping.commands());
    }

    private Knots knots(Window window) {
        return Knots.of(of.run(), window, step(stepping.rough()));
    }

    private static double step(BelievedModel model) {
        return model.scenario().timeStep().delta();
    }

    /** The variant from a start, then from the same with each number moved, then others. */
    private List<Entrant> entrants(Window window, Moves moves) {
        RigidMotion start = window.start();
        List<Entrant> entrants = new ArrayList<>(fromAllStarts(window.from(), start));
        moves.variants().forEach(other -> entrants.add(new Entrant(other, start)));
        return entrants;
    }

    /**
     * The variant from a start at a sample, then from the same with each of its numbers moved: the
     * same one again if that stays.
     */
    List<Entrant> fromAllStarts(int sample, RigidMotion start) {
        Entrant asItIs = new Entrant(variant, start);
        boolean[] isShown = of.shown(sample);
        List<Entrant> entrants = new ArrayList<>();
        entrants.add(asItIs);
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            double[] by = new double[RigidMotion.SIZE];
            by[i] = step(i);
            double[] change = stepping.model().startable(by);
            boolean stays = isNone(change) || (!isShown[i] && isNone(stepping.model().free(by)));
            entrants.add(stays ? asItIs : new Entrant(variant, start.plus(change)));
        }
        return entrants;
    }

    private static boolean isNone(double[] change) {
        return Arrays.stream(change).allMatch(number -> number == 0);
    }

    private double[] misses(Window window, Entrant of, RigidMotion[] motion, int group) {
        int samples = window.samples(this.of.run());
        return this.of.of(motion, of.variant().sensing(), window.from(), samples, group);
    }

    /** Differences over a step; 0 if what was moved got lost: nothing is known of it. */
    public static double[] slope(double[] moved, double[] before, double step) {
        double[] slope = new double[before.length];
        for (int i = 0; i < before.length; i++) {
            slope[i] = (moved[i] - before[i]) / step;
            if (Double.isNaN(slope[i])) {
                return new double[before.length];
            }
        }
        return slope;
    }

    /** The same of differences. */
    static double[] slope(double[] difference, double step) {
        return slope(difference, new double[difference.length], step);
    }
}
