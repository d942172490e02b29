package org.auvsim.bench.peers;

import org.auvsim.core.step.Lanes;
import org.auvsim.core.world.World;
import org.auvsim.experiments.bench.Measurement;
import org.auvsim.experiments.bench.StepperChoice;
import org.auvsim.experiments.bench.WorkloadBench;
import org.auvsim.experiments.workload.Workload;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Prints how fast each engine runs the workload, with the overlap that it allows and the energy
 * that it ends with, beside this one: same process, same run, one after the other.
 */
public final class Peers {
    private static final int REPETITIONS = 3;
    private static final double WARM_UP_SECONDS = 3;

    /** A run that takes longer (s) is ended early, and its row says where. */
    private static final double PATIENCE = 60;

    private Peers() {}

    /** Arguments: numbers of bodies; 100, 1000, 10000 and 100000 if there are none. */
    public static void main(String[] arguments) {
        List<Integer> numbers =
                arguments.length == 0
                        ? List.of(100, 1_000, 10_000, 100_000)
                        : Arrays.stream(arguments).map(Integer::valueOf).toList();
        List<Peer> peers = List.of(new Jolt(1), new Ode(), new Bullet());
        print(
                "%-30s %8s %8s %16s %16s %12s%n",
                "engine", "bodies", "world s", "times real time", "overlap (radii)", "energy (J)");
        for (int n : numbers) {
            Workload workload = Workload.of(n);
            ours(workload);
            peers.forEach(peer -> theirs(peer, workload));
        }
    }

    private static void ours(Workload workload) {
        WorkloadBench bench =
                new WorkloadBench(StepperChoice.EVENT, Lanes.ONE, WARM_UP_SECONDS, REPETITIONS);
        World start = workload.world().build();
        Measurement m = bench.measure(workload, workload.duration(), () -> false).orElseThrow();
        double energy = workload.energy(start) * (1 + m.energyDrift() / 100);
        row("auvsim", m.bodies(), m.seconds(), m.timesRealTime(), m.largestOverlap(), energy);
    }

    private static void theirs(Peer peer, Workload workload) {
        double best = 0;
        for (int k = 0; k < REPETITIONS; k++) {
            try (PeerWorld world = peer.world(workload)) {
                PeerRun run = new PeerRun(workload, world);
                run.run(workload.duration(), PATIENCE);
                best = Math.max(best, run.timesRealTime());
                if (k == REPETITIONS - 1) {
                    row(
                            peer.name(),
                            workload.bodies(),
                            run.seconds(),
                            best,
                            run.largestOverlap(),
                            run.energy());
                }
            }
        }
    }

    private static void row(
            String engine,
            int bodies,
            double seconds,
            double speed,
            double overlap,
            double energy) {
        print(
                "%-30s %8d %8.4g %16.4g %16.2g %12.1f%n",
                engine, bodies, seconds, speed, overlap, energy);
    }

    private static void print(String format, Object... values) {
        System.out.printf(Locale.ROOT, format, values);
    }
}
