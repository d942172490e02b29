package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.core.behavior.GoToPoint;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.server.feedback.LockstepTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Input;
import org.auvsim.server.simulator.InputLog;
import org.auvsim.server.simulator.InputPlace;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.StepMade;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;

/**
 * Five robots, each a process of its own in another language, in lock-step with the simulator:
 * their run is the run in one process, bit for bit, whoever joins first and however long they take.
 */
@Timeout(60)
class DistributedRunTest {
    private static final double END = 3;
    private static final Path ROBOT = Path.of("..", "examples", "python", "lockstep.py");
    private static final List<Vec3> STARTS =
            List.of(
                    new Vec3(4, 1, 0.5),
                    new Vec3(-3, 2, 1),
                    new Vec3(0.5, -5, -1),
                    new Vec3(-2, -1, 4),
                    new Vec3(1, 3, -3));

    /** The same law as that of the robots. */
    private static final GoToPoint DRIVE = new GoToPoint("drive", 10, 0.1, Vec3.ZERO);

    private static WorldObjectDefinition.Builder robot(int k) {
        return WorldObjectDefinition.named("robot " + (k + 1))
                .id(k + 1)
                .volume(new Sphere(0.5))
                .mass(1)
                .restitution(0.8)
                .friction(0.3)
                .position(STARTS.get(k));
    }

    private static List<Long> localHashes() {
        WorldBuilder builder = World.builder().timeStep(0.05);
        for (int k = 0; k < STARTS.size(); k++) {
            builder.add(robot(k).component(DRIVE).build());
        }
        World world = builder.build();
        List<Long> hashes = new ArrayList<>();
        while (world.time() < END - 1e-9) {
            world.advanceTimestep();
            hashes.add(world.stateHash());
        }
        assertThat(world.statistics().collisions()).as("collisions").isGreaterThan(5);
        return hashes;
    }

    private static World worldOfRobots() {
        WorldBuilder builder = World.builder().timeStep(0.05);
        for (int k = 0; k < STARTS.size(); k++) {
            builder.add(robot(k).build());
        }
        return builder.build();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void fiveProcessesInLockstepAreOneSimulation(long seed) throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        Hashes hashes = new Hashes();
        List<Process> robots = new ArrayList<>();
        try (Simulator simulator =
                Simulator.of(worldOfRobots())
                        .timestepper(new LockstepTimestepper())
                        .rate(OptionalDouble.empty())
                        .until(OptionalDouble.of(END))
                        .log(hashes)
                        .paused()
                        .transport(tcp)
                        .start()) {
            robots.addAll(join(tcp.port(), seed));
            simulator.resume();
            simulator.await();
            for (Process robot : robots) {
                assertThat(robot.waitFor()).as("a robot's exit").isZero();
            }
        } finally {
            robots.forEach(Process::destroyForcibly);
        }
        assertThat(hashes.found).isEqualTo(localHashes());
    }

    /** Starts the robots in an order drawn by the seed, and waits until all are members. */
    private static List<Process> join(int port, long seed) throws IOException {
        List<Integer> order = new ArrayList<>(List.of(0, 1, 2, 3, 4));
        Collections.shuffle(order, new Random(seed));
        List<Process> robots = new ArrayList<>();
        for (int k : order) {
            robots.add(start(port, k, seed));
        }
        for (Process robot : robots) {
            String said =
                    new BufferedReader(new InputStreamReader(robot.getInputStream(), UTF_8))
                            .readLine();
            assertThat(said).isEqualTo("a member from step 1");
        }
        return robots;
    }

    private static Process start(int port, int k, long seed) throws IOException {
        Vec3 start = STARTS.get(k);
        return new ProcessBuilder(
                        "python3",
                        ROBOT.toString(),
                        "127.0.0.1",
                        Integer.toString(port),
                        Integer.toString(k + 1),
                        Double.toString(start.x()),
                        Double.toString(start.y()),
                        Double.toString(start.z()),
                        Long.toString(seed))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    /** The state's hash after each step; written by the simulation's thread until it has ended. */
    private static final class Hashes implements InputLog {
        private final List<Long> found = Collections.synchronizedList(new ArrayList<>());

        @Override
        public void begun(World world) {}

        @Override
        public void taken(InputPlace place, Input input) {}

        @Override
        public void stepFailed(InputPlace place) {}

        @Override
        public void stepMade(StepMade step) {
            found.add(step.world().stateHash());
        }
    }
}
