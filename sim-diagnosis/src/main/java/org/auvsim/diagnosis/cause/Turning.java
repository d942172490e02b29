package org.auvsim.diagnosis.cause;

import org.auvsim.core.math.Quat;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.stream.IntStream;

/** How fast bodies turned in runs. */
final class Turning {
    private static final int LOOKS = 100;

    private Turning() {}

    /** Root mean square of the angular velocity (rad/s), as far as it was measured; else 0. */
    static double rate(List<MeasuredRun> runs) {
        double sum = 0;
        int count = 0;
        for (MeasuredRun run : runs) {
            int[] telling = telling(run);
            int stride = Math.max(1, telling.length / LOOKS);
            for (int i = stride; i < telling.length; i += stride) {
                double rate = rate(run, telling[i - stride], telling[i]);
                if (Double.isFinite(rate)) {
                    sum += rate * rate;
                    count++;
                }
            }
        }
        return count == 0 ? 0 : Math.sqrt(sum / count);
    }

    private static int[] telling(MeasuredRun run) {
        boolean isMeasured = run.measures(Channel.ANGULAR_VELOCITY);
        return IntStream.range(0, run.size())
                .filter(k -> isMeasured || run.isOriented(k))
                .toArray();
    }

    private static double rate(MeasuredRun run, int from, int to) {
        if (run.measures(Channel.ANGULAR_VELOCITY)) {
            return run.norm(Channel.ANGULAR_VELOCITY, to);
        }
        Quat before = run.orientation(from).orElseThrow();
        Quat turn = run.orientation(to).orElseThrow().times(before.conjugate());
        double sine = Math.sqrt(turn.x() * turn.x() + turn.y() * turn.y() + turn.z() * turn.z());
        double angle = 2 * StrictMath.atan2(sine, Math.abs(turn.w()));
        return angle / (run.time(to) - run.time(from));
    }
}
