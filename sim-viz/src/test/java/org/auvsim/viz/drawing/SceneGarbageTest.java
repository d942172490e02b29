package org.auvsim.viz.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.Dvl;
import org.auvsim.core.sensor.RangeSonar;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.sensor.VectorErrors;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Compound;
import org.auvsim.core.volume.Part;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Meeting;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.auvsim.viz.source.SceneAlone;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.OptionalLong;

/** Frames between two steps, with all that can be shown, by a brush that keeps nothing. */
class SceneGarbageTest {
    private static final int FRAMES = 10;
    private static final long SECOND = 1_000_000_000;

    private final Scene scene = new Scene(new LiveClock());
    private final ViewOptions options = new ViewOptions();
    private final SceneDrawing drawing =
            new SceneDrawing(new SceneAlone(scene), options, new OrbitCamera());
    private final CountingBrush brush = new CountingBrush();

    private static Volume volume(long id) {
        Volume pill = new Capsule(0.3, 1);
        return switch ((int) (id % 4)) {
            case 0 -> new Sphere(0.5);
            case 1 -> new Box(new Vec3(1, 2, 3));
            case 2 -> pill;
            default -> new Compound(List.of(new Part(pill, new Vec3(1, 0, 0), Quat.IDENTITY)));
        };
    }

    private static WorldObjectDefinition vehicle(long id) {
        Vec3 ahead = new Vec3(1, 0, 0);
        Sampling often = new Sampling(10, 0, 0, 0);
        return WorldObjectDefinition.named("Vehicle " + id)
                .mass(2)
                .volume(volume(id))
                .force(new NamedForce("Push", Frame.BODY, ahead, ahead))
                .component(new Propulsor("Aft", 10, 0.2, ahead, ahead).mounted(ahead, 0.5))
                .component(
                        new RangeSonar(
                                "Sonar",
                                Vec3.ZERO,
                                Quat.IDENTITY,
                                7,
                                2,
                                0,
                                50,
                                ScalarErrors.NONE,
                                often))
                .component(
                        new Dvl(
                                "Log",
                                Vec3.ZERO,
                                Quat.IDENTITY,
                                0.5,
                                30,
                                1,
                                VectorErrors.NONE,
                                ScalarErrors.NONE,
                                often))
                .build();
    }

    /** Each goes around a place of its own, and a step is done every second. */
    private void moving(int count) {
        for (long id = 1; id <= count; id++) {
            scene.add(SeenObject.of(id, vehicle(id)));
        }
        for (int step = 1; step <= 60; step++) {
            for (long id = 1; id <= count; id++) {
                scene.move(id, at(id, step));
                scene.project(id, at(id, step + 1));
                scene.measure(id, step, at(id, step).position());
            }
            scene.meet(new Meeting(step, 1, 2, Vec3.ZERO, Vec3.ZERO));
            scene.stepDone(step, step * SECOND);
        }
    }

    private static Movement at(long id, double time) {
        double x = 3 * (id % 10) + Math.cos(time + id);
        double y = 3 * (id / 10) + Math.sin(time + id);
        Quat turn = Quat.ofAxisAngle(new Vec3(0, 0, 1), time);
        return new Movement(time, new Vec3(x, y, 0), turn, new Vec3(0.5, 0.5, 0), Vec3.ZERO);
    }

    /** Names are left out of a crowd, and trails of a larger one. */
    @ParameterizedTest
    @ValueSource(ints = {40, 100})
    void aFrameMakesNoGarbage(int count) {
        moving(count);
        options.select(OptionalLong.of(3));
        options.follow(OptionalLong.of(4));
        long least = Long.MAX_VALUE;
        // Whatever the virtual machine does once it does not do each time.
        for (int round = 0; round < 4; round++) {
            least = Math.min(least, bytesOfFrames());
        }
        assertThat(brush.painted).isGreaterThan(4L * FRAMES * count);
        assertThat(least).isZero();
    }

    private long bytesOfFrames() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int i = 0; i < FRAMES; i++) {
            drawing.paint(brush, 60 * SECOND + i * SECOND / FRAMES);
        }
        return threads.getCurrentThreadAllocatedBytes() - before;
    }
}
