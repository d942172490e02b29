package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * One place in a run where the body is elsewhere from one sample to the next and stays there: no
 * force does that. Another run begins there, or the place was set anew.
 */
final class Jump {
    private static final int FEWEST = 20;

    /** It goes so many times as far, and as fast, as between any other two samples. */
    private static final double FAR = 8;

    private final MeasuredRun run;
    private final Source source;

    Jump(MeasuredRun run, Source source) {
        this.run = run;
        this.source = source;
    }

    /** The way from a sample to the next one that has a place (m), and its speed (m/s). */
    private record Step(int to, double way, double speed) {
        boolean isFarBeyond(Step other) {
            return way > FAR * other.way && speed > FAR * other.speed;
        }
    }

    /** What is to be said of the first axis along which it is. */
    Optional<String> notice() {
        return IntStream.range(0, 3).boxed().flatMap(axis -> notice(axis).stream()).findFirst();
    }

    private Optional<String> notice(int axis) {
        int[] samples = run.samples(Channel.POSITION, axis);
        if (samples.length < FEWEST) {
            return Optional.empty();
        }
        Step largest = new Step(0, 0, 0);
        Step others = new Step(0, 0, 0);
        for (int i = 1; i < samples.length; i++) {
            Step step = step(samples[i - 1], samples[i], axis);
            Step smaller = step.way > largest.way ? largest : step;
            largest = step.way > largest.way ? step : largest;
            others =
                    new Step(
                            0,
                            Math.max(others.way, smaller.way),
                            Math.max(others.speed, smaller.speed));
        }
        return others.way > 0 && largest.isFarBeyond(others)
                ? Optional.of(words(largest, others, axis))
                : Optional.empty();
    }

    private Step step(int from, int to, int axis) {
        double way =
                Math.abs(
                        run.value(Channel.POSITION, to, axis)
                                - run.value(Channel.POSITION, from, axis));
        return new Step(to, way, way / (run.time(to) - run.time(from)));
    }

    private String words(Step jump, Step others, int axis) {
        return source.says(
                source.row(jump.to, run),
                List.of(source.column(Channel.POSITION, axis)),
                "at %s s the body is %s m from where it was before, %s times as far as it goes between any other two rows: does another run begin here, or was its place set anew? If so, give what follows a file of its own"
                        .formatted(
                                Figures.shown(run.time(jump.to)),
                                Figures.shown(jump.way, 2),
                                Figures.shown(jump.way / others.way, 2)));
    }
}
