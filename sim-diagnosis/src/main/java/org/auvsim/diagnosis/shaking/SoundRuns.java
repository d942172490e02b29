package org.auvsim.diagnosis.shaking;

import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.StatUtils;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Runs that are known to be sound: what is normal of a body's shaking. No model has that, only
 * other runs of the same body with the same sensors.
 */
public final class SoundRuns {
    /** Of sound runs so many are taken for others. */
    private static final double FALSE_ALARMS = 0.01;

    private final BelievedModel model;
    private final double[] strengths;
    private final double interval;

    private SoundRuns(BelievedModel model, double[] strengths, double interval) {
        this.model = model;
        this.strengths = strengths;
        this.interval = interval;
    }

    /**
     * Runs of a model's body, all of each that was measured.
     *
     * @throws IllegalArgumentException naming the run that cannot be compared
     */
    public static SoundRuns of(BelievedModel model, List<MeasuredRun> runs) {
        List<Shake> shakes = new ArrayList<>();
        for (MeasuredRun run : runs) {
            if (!run.whole().tellsShaking()) {
                throw new IllegalArgumentException(
                        "run '%s' tells nothing of shaking; name the columns that do in the mapping, as <shaking acceleration=\"ax\" rate=\"wy\"/>"
                                .formatted(run.name()));
            }
            Shake shake =
                    Shake.of(run.whole(), model)
                            .orElseThrow(
                                    () ->
                                            new IllegalArgumentException(
                                                    "run '%s' has too few rows of steady thrust to tell how the body shakes; expected 16 evenly spaced ones"
                                                            .formatted(run.name())));
            if (!shakes.isEmpty()
                    && !Shake.isSame(shake.interval(), shakes.getFirst().interval())) {
                throw new IllegalArgumentException(
                        "rows of run '%s' are %s s apart, those of run '%s' %s s; how the body shakes cannot be compared"
                                .formatted(
                                        run.name(),
                                        shake.interval(),
                                        runs.getFirst().name(),
                                        shakes.getFirst().interval()));
            }
            shakes.add(shake);
        }
        if (shakes.size() < 2) {
            throw new IllegalArgumentException(
                    "there is %d reference run; expected two at least, to tell how they scatter"
                            .formatted(shakes.size()));
        }
        double[] strengths = shakes.stream().mapToDouble(Shake::strength).toArray();
        if (StatUtils.mean(strengths) == 0) {
            throw new IllegalArgumentException(
                    "nothing shakes the two sensors of the reference runs alike; name two others");
        }
        return new SoundRuns(model, strengths, shakes.getFirst().interval());
    }

    /**
     * How much other runs shake, taken together: their mean against that of these by Student's
     * distribution (1908), with the scatter of these. Which sign the covariance has depends on how
     * the sensors are mounted: it is that which it has in these runs.
     *
     * @return empty if one of them tells nothing of it, or has its rows at other intervals
     */
    public Optional<Shaking> compared(List<MeasuredRun> runs) {
        List<Shake> shakes = runs.stream().flatMap(run -> Shake.of(run, model).stream()).toList();
        boolean areAlike =
                shakes.stream().allMatch(shake -> Shake.isSame(shake.interval(), interval));
        return shakes.size() == runs.size() && areAlike
                ? Optional.of(shaking(shakes.stream().mapToDouble(Shake::strength).toArray()))
                : Optional.empty();
    }

    private Shaking shaking(double[] others) {
        double normal = StatUtils.mean(strengths);
        double scatter = Math.sqrt(StatUtils.variance(strengths)) / Math.abs(normal);
        double ofMean = scatter / Math.sqrt(strengths.length);
        double ofOthers = scatter / Math.sqrt(others.length);
        double factor = StatUtils.mean(others) / normal;
        double ofDifference = StrictMath.hypot(ofMean, ofOthers);
        double quantile =
                new TDistribution(strengths.length - 1.0)
                        .inverseCumulativeProbability(1 - FALSE_ALARMS);
        return new Shaking(
                factor,
                StrictMath.hypot(ofOthers, factor * ofMean),
                1 + quantile * ofDifference,
                (factor - 1) / ofDifference,
                strengths.length,
                others.length);
    }
}
