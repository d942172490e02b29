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
        List<Integer> measured = measured(run);
        List<UnitTrial> parts = parts(run);
        double asTold = mean(parts, measured, trial -> trial.misfit(UnitTrial.AS_TOLD, measured));
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
        Optional<MixedAxes> round = turnedRound(run, parts);
        if (round.isEmpty()) {
            return Optional.empty();
        }
        MeasuredRun unmixed = run.placed(round.get()::unmixed);
        MeasuredRun read = again.in(other).get(longest);
        boolean isOther =
                beyondNoise(parts(read), measured(read)) < beyondNoise(parts(unmixed), measured);
        return Optional.of(isOther ? suspected(other) : round.get().suspicion());
    }

    /** The same of the columns of positions alone; of several mixes, that which fits best. */
    private Optional<Suspicion> mixed(MeasuredRun run, double limit) {
        Suspicion best = null;
        double least = limit;
        for (MixedAxes mix : MixedAxes.values()) {
            double misfit = misfit(run.placed(mix::unmixed));
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
    private Optional<MixedAxes> turnedRound(MeasuredRun run, List<UnitTrial> asTold) {
        return Arrays.stream(MixedAxes.values())
                .filter(
                        mix ->
                                mix.turnsRound()
                                        .filter(axis -> isTurned(run, asTold, mix, axis))
                                        .isPresent())
                .findFirst();
    }

    private boolean isTurned(MeasuredRun run, List<UnitTrial> asTold, MixedAxes mix, int axis) {
        List<Integer> others = new ArrayList<>(measured(run));
        if (!others.remove(Integer.valueOf(axis))) {
            return false;
        }
        double told = beyondNoise(asTold, List.of(axis));
        if (!(told >= FITS_NOT) || !(beyondNoise(asTold, others) < FITS_NOT)) {
            return false;
        }
        List<UnitTrial> turned = parts(run.placed(mix::unmixed));
        return beyondNoise(turned, List.of(axis)) <= Math.min(FITS, told / BETTER_ALONE)
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

    private static List<Integer> measured(MeasuredRun run) {
        return IntStream.range(0, 3)
                .filter(axis -> run.measures(Channel.POSITION, axis))
                .boxed()
                .toList();
    }

    /** Parts of a run by the model, each begun as measured; none of a run that is too short. */
    private List<UnitTrial> parts(MeasuredRun run) {
        int size = run.size() / PARTS;
        return size < UnitTrial.FEWEST
                ? List.of()
                : IntStream.range(0, PARTS)
                        .map(part -> part * size)
                        .mapToObj(from -> UnitTrial.of(model, run, from, from + size - 1))
                        .map(trial -> trial.of(List.of()))
                        .toList();
    }

    private double misfit(MeasuredRun run) {
        List<Integer> axes = measured(run);
        return mean(parts(run), axes, trial -> trial.misfit(UnitTrial.AS_TOLD, axes));
    }

    /** The mean misfit of parts less what noise leaves, as a share of what forces do. */
    private static double beyondNoise(List<UnitTrial> parts, List<Integer> axes) {
        return mean(parts, axes, trial -> trial.beyondNoise(axes));
    }

    private static double mean(
            List<UnitTrial> parts, List<Integer> axes, ToDoubleFunction<UnitTrial> misfit) {
        return axes.isEmpty()
                ? Double.NaN
                : parts.stream().mapToDouble(misfit).average().orElse(Double.NaN);
    }
}
