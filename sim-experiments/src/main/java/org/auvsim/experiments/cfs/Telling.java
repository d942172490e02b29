package org.auvsim.experiments.cfs;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.core.math.Vec3;
import org.auvsim.experiments.live.Robot;
import org.auvsim.plot.page.Curve.Point;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** A robot that tells where it is along y, and keeps what it has told. */
abstract sealed class Telling implements Robot {
    private final List<Point> told = new ArrayList<>();
    private Vec3 before = Vec3.ZERO;

    @Override
    public List<Message> begin() {
        return List.of();
    }

    /** Tells that it is at {@code y} (m) at a time (s), while its object is elsewhere. */
    final List<Message> tell(double time, Vec3 simulated, double y) {
        Vec3 actual = new Vec3(0, y, 0);
        told.add(new Point(time, y));
        Message feedback =
                new DifferentPositionFeedbackMessage(
                        Vehicle.ID,
                        time,
                        "DirectPositionChangeFeedbackHandler",
                        simulated,
                        actual,
                        before);
        before = actual;
        return List.of(feedback);
    }

    /** What it has told: y (m) over time (s). To be read when the run is over. */
    List<Point> told() {
        return List.copyOf(told);
    }

    /** B: goes along with its object, but now and then it is a little elsewhere. */
    static final class Hiccups extends Telling {
        private static final int EVERY = 10;
        private static final long SEED = 2012;

        /** The largest hiccup (m). */
        static final double LARGEST = 0.1;

        private final SplittableRandom random = new SplittableRandom(SEED);
        private int updates;

        @Override
        public List<Message> answer(double time, Vec3 simulated) {
            updates++;
            if (updates % EVERY != 0) {
                return List.of();
            }
            double hiccup = random.nextDouble(-LARGEST, LARGEST);
            return tell(time, simulated, simulated.y() + hiccup);
        }
    }

    /** C: ignores its object, and goes its own way at a constant speed. */
    static final class OwnWay extends Telling {
        /** Its speed (m/s). */
        static final double SPEED = 0.05;

        private double own;
        private double last;

        @Override
        public List<Message> answer(double time, Vec3 simulated) {
            own += SPEED * (time - last);
            last = time;
            return tell(time, simulated, own);
        }
    }
}
