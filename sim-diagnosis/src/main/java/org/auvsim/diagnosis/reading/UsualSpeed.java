package org.auvsim.diagnosis.reading;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.stream.IntStream;

/** How fast bodies go that robots are tried with: what is faster is told in another unit. */
record UsualSpeed(BelievedModel model, MeasuredRun run) {
    /** No such vehicle is as fast (m/s). */
    private static final double VEHICLE = 100;

    /** Nothing else that is thrown or falls is as fast (m/s). */
    private static final double ANYTHING = 1500;

    /** A path is taken by so many straight lines: between neighbours noise would pass for speed. */
    private static final int LINES = 20;

    /** The axes along which the run's positions go too fast for its body. */
    List<Integer> exceeded() {
        boolean isVehicle =
                model.variant().body().component().stream().anyMatch(Propulsor.class::isInstance);
        double most = isVehicle ? VEHICLE : ANYTHING;
        return IntStream.range(0, 3).filter(axis -> speed(axis) > most).boxed().toList();
    }

    /** The mean speed (m/s) to and fro along an axis. */
    double speed(int axis) {
        double way = 0;
        double last = Double.NaN;
        for (int line = 0; line <= LINES; line++) {
            int sample = (int) ((long) line * (run.size() - 1) / LINES);
            double place = run.value(Channel.POSITION, sample, axis);
            if (!Double.isNaN(place)) {
                way += Double.isNaN(last) ? 0 : Math.abs(place - last);
                last = place;
            }
        }
        return way / run.duration();
    }
}
