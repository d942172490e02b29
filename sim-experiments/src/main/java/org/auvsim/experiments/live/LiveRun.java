package org.auvsim.experiments.live;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.FeedbackTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.net.TransportException;
import org.auvsim.server.simulator.Input;
import org.auvsim.server.simulator.InputLog;
import org.auvsim.server.simulator.InputPlace;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.StepMade;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Consumer;

/**
 * A run of a world in a simulator, with robots on threads of their own that are connected by TCP.
 *
 * @param timestepper how the simulator takes what the robots say
 * @param rate world seconds a second; empty: as fast as possible
 * @param until world time at its end (s)
 */
public record LiveRun(FeedbackTimestepper timestepper, OptionalDouble rate, double until) {
    /**
     * Runs a world to the end; time goes on when all robots have joined.
     *
     * @param watch is shown the world after each step, on the simulation's thread
     * @throws IOException if a robot loses the simulator before the end, or it cannot listen
     */
    public void run(World world, List<Participant> robots, Consumer<World> watch)
            throws IOException {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        List<FutureTask<Boolean>> parts = new ArrayList<>();
        List<RobotLink> links = new ArrayList<>();
        Watch log = new Watch(watch, until);
        try (Simulator simulator = simulator(world, tcp, log)) {
            for (Participant robot : robots) {
                links.add(join(tcp.port(), robot));
            }
            for (RobotLink link : links) {
                parts.add(new FutureTask<>(() -> takePart(link, log)));
            }
            parts.forEach(Thread::startVirtualThread);
            simulator.resume();
            for (FutureTask<Boolean> part : parts) {
                finish(part);
            }
            simulator.await();
        } finally {
            links.forEach(RobotLink::close);
        }
    }

    private Simulator simulator(World world, TcpTransport tcp, Watch log) throws IOException {
        try {
            return Simulator.of(world)
                    .timestepper(timestepper)
                    .rate(rate)
                    .until(OptionalDouble.of(until))
                    .log(log)
                    .paused()
                    .transport(tcp)
                    .start();
        } catch (TransportException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    private RobotLink join(int port, Participant robot) throws ConnectionException {
        AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", port);
        RobotLink link = new RobotLink(client, robot, timestepper.isLockstep());
        link.join();
        return link;
    }

    /**
     * Takes part; that the simulator goes while an answer is on its way is an end like others.
     *
     * @return whether all answers were heard
     */
    private static boolean takePart(RobotLink link, Watch log) throws ConnectionException {
        try {
            link.takePart();
            return true;
        } catch (ConnectionException e) {
            if (!log.isOver) {
                throw e;
            }
            return false;
        }
    }

    private static void finish(FutureTask<Boolean> part) throws IOException {
        try {
            part.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof ConnectionException lost) {
                throw lost;
            }
            throw new IllegalStateException("a robot failed", e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted while a robot took part", e);
        }
    }

    /** Shows the world after each step, and knows when it has come to its end. */
    private static final class Watch implements InputLog {
        /** Sums of time steps round (s). */
        private static final double ROUNDING = 1e-9;

        private final Consumer<World> watch;
        private final double until;
        private volatile boolean isOver;

        Watch(Consumer<World> watch, double until) {
            this.watch = watch;
            this.until = until;
        }

        @Override
        public void begun(World world) {
            // The world is watched from its first step on.
        }

        @Override
        public void taken(InputPlace place, Input input) {
            // What robots send is seen in what the world does.
        }

        @Override
        public void stepFailed(InputPlace place) {
            // The robots are told, and end the run.
        }

        @Override
        public void stepMade(StepMade step) {
            watch.accept(step.world());
            isOver = step.world().time() >= until - ROUNDING;
        }
    }
}
