package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.MeasuredAxes;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * Whether runs may be told in other axes than they are read in, or columns of positions mixed up:
 * the model then bends as they do once they are read so, and not before. A body that its weight or
 * its actuators move says so; one that moves the same way in either says nothing.
 */
final class ModelAxes {
    /**
     * A misfit of this share of what forces do is little; for the model may lack something, too.
     */
    private static final double FITS = 0.5;

    /** A misfit of this share, and so many times that in other axes, is that of other axes. */
    private static final double FITS_NOT = 0.9;

    private static final double BETTER = 3;

    /** The same of one axis alone, which little moves. */
    private static final double BETTER_ALONE = 5;

    private static final int PARTS = 3;

    private final BelievedModel model;
    private final MeasuredAxes axes;

    ModelAxes(BelievedModel model, MeasuredAxes axes) {
        this.model = model;
        this.axes = axes;
    }

    /** Reads the same runs again. */
    @FunctionalInterface
    interface Again {
        List<MeasuredRun> in(MeasuredAxes other) throws DocumentException;
    }

    /** What is suspected, if anything is. */
    Optional<Suspicion> suspicion(List<MeasuredRun> runs, Again again) throws DocumentException {
        int longest =
                IntStream.range(0, runs.size())
                        .boxed()
                        .max(Comparator.comparingDouble(i -> runs.get(i).duration()))
                        .orElseThrow();
        MeasuredRun run = runs.get(longest);
        MeasuredAxes other = axes == MeasuredAxes.NED ? MeasuredAxes.ENU : MeasuredAxes.NED;
        double asTold = misfit(run);
        double limit = Math.min(FITS, asTold / BETTER);
        if (asTold >= FITS_NOT) {
            if (misfit(again.in(other).get(longest)) <= limit) {
                return Optional.of(suspected(other));
            }
            Optional<Suspicion> mixed = mixed(run, limit);
            if (mixed.isPresent()) {
                return mixed;
            }
        }
        Optional<MixedAxes> round = turnedRound(run);
        if (round.isEmpty()) {
            return Optional.empty();
        }
        double ofRound = beyondNoise(run.placed(round.get()::unmixed));
        boolean isOther = beyondNoise(again.in(other).get(longest)) < ofRound;
        return Optional.of(isOther ? suspected(other) : round.get().suspicion());
    }

    /** The same of the columns of positions alone; of several mixes, that which fits best. */
    private Optional<Suspicion> mixed(MeasuredRun run, double limit) {
        Suspicion best = null;
        double least = limit;
        for (MixedAxes mix : MixedAxes.values()) {
            MeasuredRun unmixed = run.placed(mix::unmixed);
            double misfit = misfit(unmixed);
            if (misfit < least) {
                least = misfit;
                best = mix.suspicion();
            }
        }
        return Optional.ofNullable(best);
    }

    /**
     * One axis alone that is positive the other way, where the model moves as told along others.
     */
    private Optional<MixedAxes> turnedRound(MeasuredRun run) {
        return Arrays.stream(MixedAxes.values())
                .filter(
                        mix ->
                                mix.turnsRound()
                                        .filter(axis -> isTurned(run, mix, axis))
                                        .isPresent())
                .findFirst();
    }

    private boolean isTurned(MeasuredRun run, MixedAxes mix, int axis) {
        List<Integer> others = new ArrayList<>(measured(run));
        if (!others.remove(Integer.valueOf(axis)) || others.isEmpty()) {
            return false;
        }
        double asTold = beyondNoise(run, List.of(axis));
        if (asTold < FITS_NOT || !(beyondNoise(run, others) < FITS_NOT)) {
            return false;
        }
        MeasuredRun turned = run.placed(mix::unmixed);
        return beyondNoise(turned, List.of(axis)) <= Math.min(FITS, asTold / BETTER_ALONE)
                && beyondNoise(turned, others) < FITS_NOT;
    }

    private static Suspicion suspected(MeasuredAxes other) {
        return switch (other) {
            case NED -> suspected("x is north, y east and z down", "say so (--ned)");
            case ENU ->
                    suspected(
                            "x is east, y north and z up",
                            "leave out --ned, or axes=\"NED\" of the mapping");
        };
    }

    private static Suspicion suspected(String axes, String remedy) {
        return new Suspicion(
                "the model moves as this does if " + axes,
                ": are these the axes? If so, " + remedy,
                ", but it is explained in the axes in which it was read");
    }

    private double misfit(MeasuredRun run) {
        return misfit(run, measured(run));
    }

    private double beyondNoise(MeasuredRun run) {
        return beyondNoise(run, measured(run));
    }

    private static List<Integer> measured(MeasuredRun run) {
        return IntStream.range(0, 3)
                .filter(axis -> run.measures(Channel.POSITION, axis))
                .boxed()
                .toList();
    }

    /**
     * The mean misfit of parts of a run along axes, each begun as measured, as a share of what
     * forces do.
     */
    private double misfit(MeasuredRun run, List<Integer> axes) {
        return ofParts(run, axes, trial -> trial.misfit(UnitTrial.AS_TOLD, axes));
    }

    /** The same less what noise leaves. */
    private double beyondNoise(MeasuredRun run, List<Integer> axes) {
        return ofParts(run, axes, trial -> trial.beyondNoise(axes));
    }

    private double ofParts(
            MeasuredRun run, List<Integer> axes, ToDoubleFunction<UnitTrial> misfit) {
        int size = run.size() / PARTS;
        if (axes.isEmpty() || size < UnitTrial.FEWEST) {
            return Double.NaN;
        }
        double sum = 0;
        for (int part = 0; part < PARTS; part++) {
            UnitTrial trial = UnitTrial.of(model, run, part * size, (part + 1) * size - 1);
            sum += misfit.applyAsDouble(trial.of(List.of()));
        }
        return sum / PARTS;
    }
}
