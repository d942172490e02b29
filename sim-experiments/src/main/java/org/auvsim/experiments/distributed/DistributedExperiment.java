package org.auvsim.experiments.distributed;

import org.auvsim.core.world.World;
import org.auvsim.experiments.Conduct;
import org.auvsim.experiments.ThesisExperiment;
import org.auvsim.experiments.live.LiveRun;
import org.auvsim.experiments.live.Participant;
import org.auvsim.plot.page.Report;
import org.auvsim.server.feedback.AsynchronousFeedbackTimestepper;
import org.auvsim.server.feedback.LockstepTimestepper;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Five spheres driven inside the simulator, and by five clients in each of three further runs
 * (thesis, section 8.3): asynchronously, as there, and in lock-step.
 */
public final class DistributedExperiment implements ThesisExperiment {
    private static final double SECONDS = 60;
    private static final double QUICK_SECONDS = 10;

    /** So much faster than real time the asynchronous runs go: a step is 5 ms. */
    private static final double RATE = 10;

    /** World time (s) of runs before that do not count, in which the machine code gets ready. */
    private static final double WARM_UP = 5;

    private static final int DISTRIBUTED_RUNS = 3;

    @Override
    public Optional<Report> run(Conduct conduct) throws IOException {
        double seconds = conduct.quick() ? QUICK_SECONDS : SECONDS;
        conduct.tell("a first run that is not counted, in which the machine code gets ready");
        lockstep(WARM_UP).run(Scene.world(Optional.empty()), drivers(), _ -> {});
        asynchronous(WARM_UP).run(Scene.world(Optional.empty()), drivers(), _ -> {});
        conduct.tell("run 1, inside the simulator, %s s of world time".formatted(seconds));
        Trace local = local(seconds);
        List<Trace> asynchronous = distributed("asynchronous", 2, asynchronous(seconds), conduct);
        List<Trace> lockstep =
                distributed("lock-step", 2 + DISTRIBUTED_RUNS, lockstep(seconds), conduct);
        return conduct.isStopped()
                ? Optional.empty()
                : Optional.of(new DistributedReport(RATE, local, asynchronous, lockstep).report());
    }

    private static LiveRun asynchronous(double seconds) {
        return new LiveRun(new AsynchronousFeedbackTimestepper(), OptionalDouble.of(RATE), seconds);
    }

    private static LiveRun lockstep(double seconds) {
        return new LiveRun(new LockstepTimestepper(), OptionalDouble.empty(), seconds);
    }

    private static Trace local(double seconds) {
        Trace trace = new Trace("run 1: inside the simulator");
        World world = Scene.world(Optional.of(Scene.LAW));
        while (world.time() < seconds - 1e-9) {
            world.advanceTimestep();
            trace.note(world);
        }
        return trace;
    }

    private static List<Trace> distributed(String how, int first, LiveRun run, Conduct conduct)
            throws IOException {
        List<Trace> traces = new ArrayList<>();
        for (int k = first; k < first + DISTRIBUTED_RUNS && !conduct.isStopped(); k++) {
            String name = "run %d: five clients, %s".formatted(k, how);
            conduct.tell(name);
            Trace trace = new Trace(name);
            run.run(Scene.world(Optional.empty()), drivers(), trace::note);
            traces.add(trace);
        }
        return traces;
    }

    private static List<Participant> drivers() {
        List<Participant> drivers = new ArrayList<>();
        for (int k = 0; k < Scene.STARTS.size(); k++) {
            drivers.add(
                    new Participant(
                            k + 1,
                            Scene.STARTS.get(k),
                            new Driver(k + 1, Scene.STARTS.get(k), Scene.LAW)));
        }
        return drivers;
    }
}
