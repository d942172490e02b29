package org.auvsim.bench.peers;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.experiments.workload.Targets;
import org.auvsim.experiments.workload.Workload;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;

/** The peers do what the comparison takes for granted. */
class PeersTest {
    static List<Peer> peers() {
        return List.of(new Ode(), new Jolt(1), new Bullet());
    }

    /** Two that are driven to one point meet before it; each comes back on its own side. */
    @ParameterizedTest
    @MethodSource("peers")
    void spheresBounce(Peer peer) {
        double[] places = new double[6];
        double nearest = Double.POSITIVE_INFINITY;
        Workload two = Workload.of(2).withTargets(Targets.COMMON);
        try (PeerWorld world = peer.world(two)) {
            PeerRun run = new PeerRun(two, world);
            for (int k = 0; k < 30; k++) {
                run.run(Workload.TIME_STEP, 1);
                world.positions(places);
                assertThat(places[0]).isNegative();
                assertThat(places[3]).isPositive();
                nearest = Math.min(nearest, places[3] - places[0]);
            }
        }
        assertThat(nearest).isLessThan(3);
        assertThat(places[3] - places[0]).isGreaterThan(nearest);
    }

    /** 10 N on 1 kg for a step of 0.05 s. */
    @ParameterizedTest
    @MethodSource("peers")
    void aForceActsForOneStep(Peer peer) {
        double[] velocities = new double[3];
        Workload one = Workload.of(1);
        try (PeerWorld world = peer.world(one)) {
            world.step(new double[] {10, 0, 0}, 0.05);
            world.step(new double[] {0, 0, 0}, 0.05);
            world.velocities(velocities);
        }
        assertThat(velocities[0]).isBetween(0.4999, 0.5001);
        assertThat(velocities[1]).isZero();
    }

    @ParameterizedTest
    @MethodSource("peers")
    void theWorkloadCollapsesAndItsEnergyStaysInBounds(Peer peer) {
        Workload workload = Workload.of(30);
        try (PeerWorld world = peer.world(workload)) {
            PeerRun run = new PeerRun(workload, world);
            double before = run.energy();
            run.run(10, 60);
            assertThat(run.seconds()).isBetween(9.99, 10.01);
            assertThat(run.largestOverlap()).isPositive();
            assertThat(run.energy()).isBetween(0.5 * before, 2 * before);
        }
    }
}
