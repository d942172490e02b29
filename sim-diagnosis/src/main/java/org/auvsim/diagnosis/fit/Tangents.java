package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Tangent;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;

import java.util.List;
import java.util.stream.IntStream;

/** Derivatives of all windows of a fit by their starts and by its parameters, run by run. */
final class Tangents {
    private final List<List<Tangent>> all;

    private Tangents(List<List<Tangent>> all) {
        this.all = all;
    }

    /** One of a window of a run. */
    @FunctionalInterface
    private interface One {
        Tangent of(Shooting shooting, Moves moves, int run, int number);
    }

    /** Taken where the windows of a fit are. */
    static Tangents of(Simulated fit) {
        double[] numbers = fit.fit().hypothesis().numbers();
        return all(
                fit.fit(),
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

    private static Tangents all(Fit fit, One one) {
        Moves moves = fit.hypothesis().moves(fit.stepping().variant());
        return new Tangents(
                IntStream.range(0, fit.data().size())
                        .parallel()
                        .mapToObj(r -> ofRun(fit, r, moves, one))
                        .toList());
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
