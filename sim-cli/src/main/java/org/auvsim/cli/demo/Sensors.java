package org.auvsim.cli.demo;

import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.feedback.DifferentStateFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;
import java.util.SplittableRandom;

/** What the robot measures of itself, and for whom. */
final class Sensors {
    private static final double POSITION_NOISE = 0.005;
    private static final double ANGLE_NOISE = 0.005;

    private final String handler;
    private final int every;
    private final boolean tellsOrientation;
    private final SplittableRandom noise = new SplittableRandom(Demonstration.SEED);

    /**
     * Those of a robot.
     *
     * @param handler the feedback processor to name
     * @param every so many steps they are read
     * @param tellsOrientation whether there is a compass with a level beside the positions
     */
    Sensors(String handler, int every, boolean tellsOrientation) {
        this.handler = handler;
        this.every = every;
        this.tellsOrientation = tellsOrientation;
    }

    boolean areReadAt(int step) {
        return step % every == 0;
    }

    /**
     * What they tell.
     *
     * @param before where the robot was when it told last
     */
    FeedbackMessage feedback(MovementStateChangeMessage projected, TrueRobot body, Vec3 before) {
        Vec3 measured = body.position().plus(noise(POSITION_NOISE));
        if (!tellsOrientation) {
            return new DifferentPositionFeedbackMessage(
                    Demonstration.ROBOT_ID,
                    projected.timestamp(),
                    handler,
                    projected.position(),
                    measured,
                    before);
        }
        return new DifferentStateFeedbackMessage(
                Demonstration.ROBOT_ID,
                projected.timestamp(),
                handler,
                Optional.empty(),
                Optional.of(measured),
                Optional.of(orientation(body.heading())),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    private Vec3 noise(double deviation) {
        return new Vec3(noise.nextGaussian(), noise.nextGaussian(), noise.nextGaussian())
                .times(deviation);
    }

    private Quat orientation(double heading) {
        Vec3 half = new Vec3(0, 0, heading).plus(noise(ANGLE_NOISE)).times(0.5);
        double cos = StrictMath.cos(half.z());
        return new Quat(cos, half.x(), half.y(), StrictMath.sin(half.z())).normalized();
    }
}
