package org.auvsim.experiments.cfs;

import org.auvsim.core.world.World;
import org.auvsim.experiments.Conduct;
import org.auvsim.experiments.ThesisExperiment;
import org.auvsim.experiments.live.LiveRun;
import org.auvsim.plot.page.Curve.Point;
import org.auvsim.plot.page.Report;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.feedback.LockstepTimestepper;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;

/**
 * One object, three times (thesis, section 8.1): A alone, B with a client that has hiccups, C with
 * a client that goes its own way; B and C asynchronously, as there, and in lock-step.
 */
public final class CfsExperiment implements ThesisExperiment {
    private static final double SECONDS = 120;
    private static final double QUICK_SECONDS = 20;
    private static final double GROWTH_SECONDS = 1000;
    private static final double QUICK_GROWTH_SECONDS = 100;

    /** World time (s) of a run before that does not count: the machine code gets ready. */
    private static final double WARM_UP = 5;

    /** So much faster than real time the asynchronous runs go: a step is 1 ms. */
    private static final double RATE = 50;

    @Override
    public Optional<Report> run(Conduct conduct) throws IOException {
        double seconds = conduct.quick() ? QUICK_SECONDS : SECONDS;
        conduct.tell("a first run that is not counted, in which the machine code gets ready");
        c("warming up", asynchronous(WARM_UP));
        conduct.tell("A, alone, %s s of world time".formatted(seconds));
        List<Point> alone = alone(seconds);
        Runs asynchronous = runs("asynchronous", asynchronous(seconds), conduct);
        Runs lockstep = runs("lock-step", lockstep(seconds), conduct);
        List<Growth> growth =
                growth(conduct.quick() ? QUICK_GROWTH_SECONDS : GROWTH_SECONDS, conduct);
        return conduct.isStopped()
                ? Optional.empty()
                : Optional.of(new CfsReport(RATE, alone, asynchronous, lockstep, growth).report());
    }

    /** B and C with the same time-stepper. */
    record Runs(FeedbackRun b, FeedbackRun c) {}

    private static LiveRun asynchronous(double seconds) {
        return new LiveRun(new AsynchronousFeedbackTimestepper(), OptionalDouble.of(RATE), seconds);
    }

    private static LiveRun lockstep(double seconds) {
        return new LiveRun(new LockstepTimestepper(), OptionalDouble.empty(), seconds);
    }

    private static List<Point> alone(double seconds) {
        World world = Vehicle.toAndFro(Vehicle.TIME_STEP);
        List<Point> course = new ArrayList<>();
        while (world.time() < seconds) {
            world.advanceTimestep();
            course.add(new Point(world.time(), Vehicle.y(world)));
        }
        return course;
    }

    private static Runs runs(String how, LiveRun run, Conduct conduct) throws IOException {
        conduct.tell("B, whose client has hiccups, %s".formatted(how));
        World moving = Vehicle.toAndFro(Vehicle.TIME_STEP);
        FeedbackRun b = FeedbackRun.of("B, " + how, run, moving, new Telling.Hiccups());
        conduct.tell("C, whose client goes its own way, %s".formatted(how));
        return new Runs(b, c("C, " + how, run));
    }

    private static FeedbackRun c(String name, LiveRun run) throws IOException {
        return FeedbackRun.of(name, run, Vehicle.atRest(), new Telling.OwnWay());
    }

    private static List<Growth> growth(double until, Conduct conduct) {
        return DoubleStream.of(0.05, 0.01, 0.001)
                .mapToObj(
                        timeStep -> {
                            conduct.tell(
                                    "A's growth over %s s in steps of %s s"
                                            .formatted(until, timeStep));
                            return Growth.of(timeStep, until, conduct);
                        })
                .toList();
    }
}
