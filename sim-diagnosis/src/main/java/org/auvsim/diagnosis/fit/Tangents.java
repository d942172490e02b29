package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Tangent;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/** Derivatives of all windows of a fit by their starts and by its parameters, run by run. */
final class Tangents {
    /**
     * By so many standard deviations, of all numbers together, a step may move what is missed where
     * derivatives are to be exact: parameters that undo each other are told by small differences of
     * large columns.
     */
    private static final double CLOSE = 0.03;

    private final List<List<Tangent>> all;
    private final double[] steps;

    private Tangents(List<List<Tangent>> all, double[] steps) {
        this.all = all;
        this.steps = steps;
    }

    /** One of a window of a run. */
    @FunctionalInterface
    private interface One {
        Tangent of(Shooting shooting, Moves moves, int run, int number);
    }

    /** Taken where the windows of a fit are. */
    static Tangents of(Simulated fit) {
        return of(fit, fit.fit().hypothesis().steps());
    }

    /** The same over steps that are as short as exact ones need to be. */
    static Tangents close(Simulated fit) {
        Tangents usual = of(fit);
        double[] shorter = usual.steps.clone();
        for (int p = 0; p < shorter.length; p++) {
            shorter[p] = Math.min(shorter[p], CLOSE / usual.size(p));
        }
        return Arrays.equals(shorter, usual.steps) ? usual : of(fit, shorter);
    }

    /**
     * By how many standard deviations, of all numbers together, a parameter moves what is missed.
     */
    private double size(int parameter) {
        return Math.sqrt(
                all.stream()
                        .flatMap(List::stream)
                        .mapToDouble(of -> of.derivatives().squares(parameter))
                        .sum());
    }

    private static Tangents of(Simulated fit, double[] steps) {
        double[] numbers = fit.fit().hypothesis().numbers();
        return all(
                fit.fit(),
                steps,
                (shooting, moves, run, number) ->
                        Tangent.of(
                                shooting,
                                fit.window(run, number),
                                fit.motion(run, number),
                                moves,
                                numbers));
    }

    /** Where the same windows are elsewhere: as they were, if they foretold what these miss. */
    Tangents at(Simulated elsewhere) {
        double[] numbers = elsewhere.fit().hypothesis().numbers();
        return all(
                elsewhere.fit(),
                steps,
                (shooting, moves, run, number) ->
                        all.get(run)
                                .get(number)
                                .at(
                                        shooting,
                                        elsewhere.window(run, number),
                                        elsewhere.motion(run, number),
                                        moves,
                                        numbers));
    }

    private static Tangents all(Fit fit, double[] steps, One one) {
        Moves moves = fit.hypothesis().moves(fit.stepping().variant(), steps);
        return new Tangents(
                IntStream.range(0, fit.data().size())
                        .parallel()
                        .mapToObj(r -> ofRun(fit, r, moves, one))
                        .toList(),
                steps);
    }

    private static List<Tangent> ofRun(Fit fit, int run, Moves moves, One one) {
        Shooting shooting = fit.shooting(fit.data().get(run));
        return IntStream.range(0, fit.windows().get(run).size())
                .parallel()
                .mapToObj(w -> one.of(shooting, moves, run, w))
                .toList();
    }

    /** Of all windows, about where they are. */
    List<List<WindowDerivatives>> derivatives() {
        return all.stream()
                .map(ofRun -> ofRun.stream().map(Tangent::derivatives).toList())
                .toList();
    }

    /** Square of what was foretold wrong since they were taken, in standard deviations. */
    double off() {
        return all.stream().flatMap(List::stream).mapToDouble(Tangent::off).sum();
    }
}
