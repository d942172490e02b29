package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;

class ObjectRowsTest {
    private final Scene scene = Scenes.withBuoy();
    private final OrbitCamera camera = new OrbitCamera();
    private final ObjectRows rows = new ObjectRows(scene, camera);

    @Test
    void readsTheObjectsAgainOnlyIfTheyAreOthers() {
        assertThat(rows.update()).isTrue();
        scene.move(9, new Movement(1, Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        assertThat(rows.update()).isFalse();
        scene.add(SeenObject.of(10, Scenes.buoy()));
        assertThat(rows.update()).isTrue();
        assertThat(rows.getRowCount()).isEqualTo(2);
        assertThat(rows.rowOf(10)).isEqualTo(1);
        assertThat(rows.rowOf(11)).isEqualTo(-1);
    }

    @Test
    void tellsSpeedAndDistanceAsTheyAreNow() {
        rows.update();
        camera.look(0, 0);
        camera.aim(0, 0, 0, 20);
        assertThat(rows.getValueAt(0, ObjectRows.DISTANCE)).isEqualTo("15.00");
        scene.jump(9, new Movement(1, Vec3.ZERO, Quat.IDENTITY, new Vec3(3, 4, 0), Vec3.ZERO));
        scene.look(0, look -> {});
        assertThat(rows.getValueAt(0, ObjectRows.SPEED)).isEqualTo("5.00");
        assertThat(rows.getValueAt(0, ObjectRows.DISTANCE)).isEqualTo("20.00");
    }
}
