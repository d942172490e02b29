package org.auvsim.viz.window;

import org.auvsim.core.math.Vec3;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

import javax.swing.table.AbstractTableModel;

/**
 * The objects as rows. How an object moves is looked up when its row is painted, so that rows out
 * of sight cost nothing.
 */
final class ObjectRows extends AbstractTableModel {
    private static final long serialVersionUID = 1L;
    static final int NAME = 0;
    static final int ID = 1;
    static final int SPEED = 2;
    static final int DISTANCE = 3;
    private static final List<String> COLUMNS = List.of("Name", "Id", "m/s", "Dist. m");

    private final transient Scene scene;
    private final transient OrbitCamera camera;
    private transient List<SeenObject> objects = List.of();
    private long revision = -1;

    ObjectRows(Scene scene, OrbitCamera camera) {
        this.scene = scene;
        this.camera = camera;
    }

    /** Reads the objects again if they are others now; whether they were. */
    boolean update() {
        long now = scene.revision();
        if (now == revision) {
            return false;
        }
        revision = now;
        objects = scene.objects();
        fireTableDataChanged();
        return true;
    }

    SeenObject object(int row) {
        return objects.get(row);
    }

    /** The row of an object, -1 if it has none. */
    int rowOf(long id) {
        for (int row = 0; row < objects.size(); row++) {
            if (objects.get(row).id() == id) {
                return row;
            }
        }
        return -1;
    }

    @Override
    public int getRowCount() {
        return objects.size();
    }

    @Override
    public int getColumnCount() {
        return COLUMNS.size();
    }

    @Override
    public String getColumnName(int column) {
        return COLUMNS.get(column);
    }

    @Override
    public Class<?> getColumnClass(int column) {
        return column == ID ? Long.class : String.class;
    }

    @Override
    public Object getValueAt(int row, int column) {
        SeenObject object = objects.get(row);
        return switch (column) {
            case NAME -> object.name();
            case ID -> object.id();
            case SPEED -> object.isFixed() ? "fixed" : live(object, m -> m.velocity().norm());
            default -> live(object, m -> m.position().distance(eye()));
        };
    }

    private String live(SeenObject object, ToDoubleFunction<Movement> quantity) {
        Optional<Movement> motion = scene.motion(object.id());
        return motion.map(m -> number(quantity.applyAsDouble(m))).orElse("");
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, Math.abs(value) < 1000 ? "%.2f" : "%.0f", value);
    }

    /** Where the camera is (m, world). */
    private Vec3 eye() {
        double away = camera.distance();
        return new Vec3(
                camera.target(0) - away * camera.forward(0),
                camera.target(1) - away * camera.forward(1),
                camera.target(2) - away * camera.forward(2));
    }
}
