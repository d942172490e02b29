package org.auvsim.experiments.cfs;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.experiments.live.LiveRun;
import org.auvsim.plot.page.Curve.Point;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.feedback.FeedbackTimestepper;
import org.auvsim.server.feedback.LockstepTimestepper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;

@Timeout(60)
class FeedbackRunTest {
    private static FeedbackRun run(FeedbackTimestepper timestepper, Telling robot)
            throws IOException {
        LiveRun live = new LiveRun(timestepper, OptionalDouble.of(100), 5);
        return FeedbackRun.of("run", live, Vehicle.atRest(), robot);
    }

    @Test
    void inLockstepTheObjectIsWhereItsClientIs() throws IOException {
        FeedbackRun run = run(new LockstepTimestepper(), new Telling.OwnWay());
        assertThat(run.told()).hasSize(100);
        assertThat(run.simulated()).isEqualTo(run.told());
        assertThat(run.largestError()).isZero();
        assertThat(run.standstill()).isZero();
    }

    /** Feedback on a step cannot be there before it: the object is a step behind, or more. */
    @Test
    void asynchronouslyItLagsBehindByAStepOrMore() throws IOException {
        FeedbackRun run = run(new AsynchronousFeedbackTimestepper(), new Telling.OwnWay());
        double step = Telling.OwnWay.SPEED * Vehicle.TIME_STEP;
        assertThat(run.errors()).hasSizeGreaterThan(5);
        assertThat(run.errors()).allSatisfy(e -> assertThat(e.y()).isLessThan(-0.99 * step));
        assertThat(run.rmsError()).isGreaterThan(0.99 * step);
    }

    @Test
    void figuresAreThoseOfThePointsThatWereTold() {
        List<Point> simulated = List.of(new Point(1, 0), new Point(2, 0), new Point(3, 2));
        FeedbackRun run =
                new FeedbackRun("", simulated, List.of(new Point(2, -3), new Point(3, 6)));
        assertThat(run.errors()).containsExactly(new Point(2, 3), new Point(3, -4));
        assertThat(run.rmsError()).isEqualTo(Math.sqrt(12.5));
        assertThat(run.largestError()).isEqualTo(4);
        assertThat(run.timeOfLargestError()).isEqualTo(3);
        assertThat(run.standstill()).isEqualTo(0.5);
    }
}
