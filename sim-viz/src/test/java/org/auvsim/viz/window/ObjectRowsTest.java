package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

class ObjectRowsTest {
    private final Scene scene = Scenes.withBuoy();
    private final OrbitCamera camera = new OrbitCamera();
    private final ObjectRows rows = new ObjectRows(scene, camera);

    private List<Object> names() {
        List<Object> names = new ArrayList<>();
        for (int row = 0; row < rows.getRowCount(); row++) {
            names.add(rows.getValueAt(row, ObjectRows.NAME));
        }
        return names;
    }

    private void addRock(String name, long id) {
        scene.add(
                SeenObject.of(
                        id,
                        WorldObjectDefinition.named(name).fixed().volume(new Sphere(1)).build()));
    }

    @Test
    void readsTheObjectsAgainOnlyIfTheyAreOthers() {
        assertThat(rows.update()).isTrue();
        scene.move(9, new Movement(1, Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        assertThat(rows.update()).isFalse();
        scene.add(SeenObject.of(10, Scenes.buoy()));
        assertThat(rows.update()).isTrue();
        assertThat(rows.getRowCount()).isEqualTo(3);
        assertThat(rows.rowOf(10)).isEqualTo(2);
        assertThat(rows.rowOf(11)).isEqualTo(-1);
    }

    @Test
    void objectsStandByWhatTheyCanDo() throws Exception {
        Scene tank = Scenes.of("bluerov2-dive.xml");
        SeenObject rov = tank.object(1).orElseThrow();
        addRock("Rock", 20);
        scene.add(rov);
        scene.add(new SeenObject(30, "Thing", Optional.empty()));
        rows.build();
        assertThat(names())
                .containsExactly(
                        "Vehicles (1)",
                        rov.name(),
                        "Free (1)",
                        "Buoy",
                        "Fixed (1)",
                        "Rock",
                        "Unknown (1)",
                        "Thing");
        rows.outline().open(rows.row(2), false);
        rows.outline().open(rows.row(1), true);
        rows.build();
        assertThat(names()).contains("Aft Port").doesNotContain("Buoy");
        assertThat(rows.idOf(2)).hasValue(1);
        assertThat(rows.outline().reveal(scene.object(9).orElseThrow())).isTrue();
        rows.build();
        assertThat(names()).contains("Buoy");
    }

    @Test
    void theFilterLeavesWhatIsWanted() {
        addRock("Rock", 20);
        rows.outline().filter(" ROC");
        rows.build();
        assertThat(names()).containsExactly("Fixed (1)", "Rock");
        rows.outline().filter("9");
        rows.build();
        assertThat(names()).containsExactly("Free (1)", "Buoy");
    }

    @Test
    void columnsOrderObjectsWithinTheirKind() {
        addRock("b", 20);
        addRock("C", 21);
        addRock("a", 22);
        RowOrder order = new RowOrder(rows);
        order.toggleSortOrder(ObjectRows.NAME);
        assertThat(names().subList(3, 6)).containsExactly("a", "b", "C");
        order.toggleSortOrder(ObjectRows.NAME);
        assertThat(names().subList(3, 6)).containsExactly("C", "b", "a");
        order.toggleSortOrder(ObjectRows.NAME);
        assertThat(names().subList(3, 6)).containsExactly("b", "C", "a");
    }

    @Test
    void numbersInNamesAreCounted() {
        addRock("Rock 10", 20);
        addRock("rock 9", 21);
        addRock("Rock", 22);
        addRock("Rock 9b", 23);
        new RowOrder(rows).toggleSortOrder(ObjectRows.NAME);
        assertThat(names().subList(3, 7)).containsExactly("Rock", "rock 9", "Rock 9b", "Rock 10");
    }

    @Test
    void speedAndDistanceOrderObjectsAgainAsTheyMove() {
        for (long id = 10; id < 13; id++) {
            scene.add(SeenObject.of(id, Scenes.buoy()));
        }
        RowOrder order = new RowOrder(rows);
        order.toggleSortOrder(ObjectRows.SPEED);
        move(9, 3);
        move(10, 2);
        move(11, 1);
        move(12, 12.5);
        awaitOrder(11, 10, 9, 12);
        assertThat(rows.getValueAt(4, ObjectRows.SPEED)).isEqualTo("12.5");
        order.toggleSortOrder(ObjectRows.SPEED);
        awaitOrder(12, 9, 10, 11);
        camera.look(0, 0);
        order.toggleSortOrder(ObjectRows.DISTANCE); // the camera is ahead, at large x
        awaitOrder(12, 9, 10, 11);
    }

    /** An object stands at x (m) and has that speed (m/s). */
    private void move(long id, double x) {
        Vec3 along = new Vec3(x, 0, 0);
        scene.jump(id, new Movement(1, along, Quat.IDENTITY, along, Vec3.ZERO));
        scene.look(0, look -> {});
    }

    private void awaitOrder(long... ids) {
        long[] seen = new long[ids.length];
        for (int turn = 0; turn < 20 && !Arrays.equals(seen, ids); turn++) {
            rows.update();
            Arrays.setAll(seen, row -> rows.idOf(row + 1).orElse(-1));
        }
        assertThat(seen).containsExactly(ids);
    }

    @Test
    void tellsSpeedAndDistanceAsTheyAreNow() {
        rows.update();
        camera.look(0, 0);
        camera.aim(0, 0, 0, 20);
        assertThat(rows.getValueAt(1, ObjectRows.DISTANCE)).isEqualTo("15.0");
        scene.jump(9, new Movement(1, Vec3.ZERO, Quat.IDENTITY, new Vec3(3, 4, 0), Vec3.ZERO));
        scene.look(0, look -> {});
        assertThat(rows.getValueAt(1, ObjectRows.SPEED)).isEqualTo("5.00");
        assertThat(rows.getValueAt(1, ObjectRows.DISTANCE)).isEqualTo("20.0");
    }
}
