package org.auvsim.viz.window;

import org.auvsim.core.math.Vec3;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.ToDoubleFunction;

import javax.swing.RowSorter.SortKey;
import javax.swing.SortOrder;
import javax.swing.table.AbstractTableModel;

/**
 * The tree of objects as rows. How an object moves is looked up when its row is painted, so that
 * rows out of sight cost nothing.
 */
final class ObjectRows extends AbstractTableModel {
    private static final long serialVersionUID = 1L;
    static final int NAME = 0;
    static final int ID = 1;
    static final int SPEED = 2;
    static final int DISTANCE = 3;
    private static final List<String> COLUMNS = List.of("Name", "Id", "m/s", "Dist. m");

    /** What moves is put in order again one turn of so many. */
    private static final int EVERY = 10;

    private final transient Scene scene;
    private final transient OrbitCamera camera;
    private final transient Outline outline = new Outline();
    private transient List<Row> rows = List.of();
    private transient Optional<SortKey> order = Optional.empty();
    private long revision = -1;
    private int turn;

    ObjectRows(Scene scene, OrbitCamera camera) {
        this.scene = scene;
        this.camera = camera;
    }

    /** What is unfolded and wanted; {@link #build} shows a change. */
    Outline outline() {
        return outline;
    }

    /** Reads the objects again if they are others now, or in another order; whether they may be. */
    boolean update() {
        boolean isOrdered = order.filter(by -> by.getColumn() >= SPEED).isPresent();
        turn = (turn + 1) % EVERY;
        if (scene.revision() == revision && !(isOrdered && turn == 0)) {
            return false;
        }
        build();
        return true;
    }

    /** Reads the objects again. */
    void build() {
        revision = scene.revision();
        outline.sort(order.map(this::comparator));
        rows = outline.rows(scene.objects());
        fireTableDataChanged();
    }

    /** Objects of each kind stand in the order of a column; empty: that of their coming. */
    void sort(Optional<SortKey> by) {
        order = by;
        build();
    }

    /** By how things stand now: objects move while they are put in order. */
    private Comparator<SeenObject> comparator(SortKey by) {
        Comparator<SeenObject> upwards =
                switch (by.getColumn()) {
                    case NAME -> Comparator.comparing(SeenObject::name, NaturalOrder.OF_TEXTS);
                    case ID -> Comparator.comparingLong(SeenObject::id);
                    case SPEED -> comparing(ObjectRows::speed);
                    default -> comparing(this::distance);
                };
        return by.getSortOrder() == SortOrder.DESCENDING ? upwards.reversed() : upwards;
    }

    private Comparator<SeenObject> comparing(ToDoubleFunction<Movement> quantity) {
        Map<Long, Double> now = new HashMap<>();
        for (SeenObject object : scene.objects()) {
            scene.motion(object.id())
                    .ifPresent(m -> now.put(object.id(), quantity.applyAsDouble(m)));
        }
        return Comparator.comparingDouble(object -> now.getOrDefault(object.id(), 0.0));
    }

    private static double speed(Movement motion) {
        return motion.velocity().norm();
    }

    private double distance(Movement motion) {
        return motion.position().distance(eye());
    }

    Row row(int row) {
        return rows.get(row);
    }

    /** The object that a row is, or that it is a part of. */
    OptionalLong idOf(int row) {
        return switch (rows.get(row)) {
            case Row.Item item -> OptionalLong.of(item.object().id());
            case Row.Part part -> OptionalLong.of(part.owner().id());
            case Row.Group _ -> OptionalLong.empty();
        };
    }

    /** Where a row stands now, -1 if it is there no more. */
    int indexOf(Row row) {
        return rows.stream().map(Row::key).toList().indexOf(row.key());
    }

    /** The row of an object, -1 if it has none. */
    int rowOf(long id) {
        for (int row = 0; row < rows.size(); row++) {
            if (rows.get(row) instanceof Row.Item(SeenObject object) && object.id() == id) {
                return row;
            }
        }
        return -1;
    }

    @Override
    public int getRowCount() {
        return rows.size();
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
    public Object getValueAt(int row, int column) {
        Row at = rows.get(row);
        if (column == NAME) {
            return at.name();
        }
        return at instanceof Row.Item(SeenObject object) ? value(object, column) : "";
    }

    private Object value(SeenObject object, int column) {
        return switch (column) {
            case ID -> object.id();
            case SPEED -> object.isFixed() ? "" : live(object, ObjectRows::speed);
            default -> live(object, this::distance);
        };
    }

    private String live(SeenObject object, ToDoubleFunction<Movement> quantity) {
        Optional<Movement> motion = scene.motion(object.id());
        return motion.map(m -> number(quantity.applyAsDouble(m))).orElse("");
    }

    private static String number(double value) {
        double size = Math.abs(value);
        return String.format(
                Locale.ROOT, size < 10 ? "%.2f" : size < 1000 ? "%.1f" : "%.0f", value);
    }

    /** Where the camera is (m, world). */
    private Vec3 eye() {
        return new Vec3(camera.position(0), camera.position(1), camera.position(2));
    }
}
