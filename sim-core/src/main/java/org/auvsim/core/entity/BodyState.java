package org.auvsim.core.entity;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;
import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.List;

/**
 * The numbers of all rigid bodies of a world: one array a quantity, one slot a body.
 *
 * <p>The thirteen columns of the state are position (m), orientation (unit quaternion, body to
 * world), linear and angular momentum (world; about the origin). Beside them stand the constants
 * that the equations of motion need. To copy a world is to copy these arrays.
 */
public final class BodyState {
    public static final int X = 0;
    public static final int Y = 1;
    public static final int Z = 2;
    public static final int QW = 3;
    public static final int QX = 4;
    public static final int QY = 5;
    public static final int QZ = 6;
    public static final int PX = 7;
    public static final int PY = 8;
    public static final int PZ = 9;
    public static final int LX = 10;
    public static final int LY = 11;
    public static final int LZ = 12;

    /** Number of columns of the state. */
    public static final int COLUMNS = 13;

    /** Inverse inertia (1/(kg m^2), body axes): positions in {@link #inverseInertia}. */
    public static final int IXX = 0;

    public static final int IYY = 1;
    public static final int IZZ = 2;
    public static final int IXY = 3;
    public static final int IXZ = 4;
    public static final int IYZ = 5;

    /** Number of elements of a symmetric tensor. */
    public static final int ELEMENTS = 6;

    private int count;
    private int behaviorChanges;
    private int equipmentChanges;

    /** How many bodies have products of inertia, and how many are fixed. */
    private int withProducts;

    private int fixed;
    private int withSpatial;
    private @Nullable SpatialInertia[] spatial = new @Nullable SpatialInertia[16];
    private final SpatialColumns spatialColumns;
    private List<Field<?>> fields = List.of();
    private List<Current> currents = List.of();
    private double time;
    private final double[][] columns;
    private final double[][] inverseInertia;
    private double[] mass;
    private double[] inverseMass;
    private double[] radius;
    private final AppliedForces applied;
    private final Actuators actuators;

    /** A state without bodies. */
    public BodyState() {
        columns = new double[COLUMNS][16];
        spatialColumns = new SpatialColumns(16);
        inverseInertia = new double[ELEMENTS][16];
        mass = new double[16];
        inverseMass = new double[16];
        radius = new double[16];
        applied = new AppliedForces(16);
        actuators = new Actuators(16);
    }

    private BodyState(BodyState original) {
        count = original.count;
        withProducts = original.withProducts;
        fixed = original.fixed;
        withSpatial = original.withSpatial;
        spatial = original.spatial.clone();
        spatialColumns = original.spatialColumns.copy();
        fields = original.fields;
        currents = original.currents;
        time = original.time;
        columns = clones(original.columns);
        inverseInertia = clones(original.inverseInertia);
        mass = original.mass.clone();
        inverseMass = original.inverseMass.clone();
        radius = original.radius.clone();
        applied = original.applied.copy();
        actuators = original.actuators.copy();
    }

    /** An independent copy, equal bit for bit. */
    public BodyState copy() {
        return new BodyState(this);
    }

    static double[][] clones(double[][] arrays) {
        double[][] copies = new double[arrays.length][];
        for (int i = 0; i < arrays.length; i++) {
            copies[i] = arrays[i].clone();
        }
        return copies;
    }

    /** How often the behaviors of an object have changed. */
    int behaviorChanges() {
        return behaviorChanges;
    }

    void behaviorsChanged() {
        behaviorChanges++;
    }

    int equipmentChanges() {
        return equipmentChanges;
    }

    void equipmentChanged() {
        equipmentChanges++;
    }

    /** Number of bodies; slots 0 to {@code count() - 1} are in use. */
    public int count() {
        return count;
    }

    /** One column of the state, {@link #X} to {@link #LZ}; index is the slot. */
    public double[] column(int column) {
        return columns[column];
    }

    /**
     * Takes other columns of the state and gives its own away in their place: a new state costs no
     * copying.
     *
     * @param other a column for each of the state, as long as its own
     */
    public void exchange(double[][] other) {
        for (int c = 0; c < COLUMNS; c++) {
            double[] mine = columns[c];
            columns[c] = other[c];
            other[c] = mine;
        }
    }

    /** One element of the inverse inertia tensors, {@link #IXX} to {@link #IYZ}; by slot. */
    public double[] inverseInertia(int element) {
        return inverseInertia[element];
    }

    /** Whether a column is of orientation or angular momentum. */
    public static boolean isRotational(int column) {
        return column >= LX || (column >= QW && column <= QZ);
    }

    /** Copies the masses of the block's bodies into it. */
    public void loadMasses(Block b) {
        b.gather(mass, b.mass);
        b.gather(inverseMass, b.inverseMass);
        b.hasSpatial = false;
        for (int i = 0; withSpatial > 0 && i < b.count; i++) {
            b.inertia[i] = spatial[b.slot(i)];
            b.hasSpatial |= b.inertia[i] != null;
        }
        if (b.hasSpatial) {
            b.spatial().load(b, spatialColumns);
        }
        b.hasFixed = false;
        for (int i = 0; fixed > 0 && i < b.count; i++) {
            b.hasFixed |= b.inverseMass[i] == 0;
        }
    }

    /** Copies the inverse inertia of the block's bodies into it, as far as one of them has it. */
    public void loadInertia(Block b) {
        for (int e = 0; e < (withProducts > 0 ? ELEMENTS : IXY); e++) {
            b.gather(inverseInertia[e], b.inverseInertia[e]);
        }
        b.hasProducts = withProducts > 0 && anyNonzero(b, IXY);
        b.hasInertia = true;
    }

    private static boolean anyNonzero(Block b, int fromElement) {
        for (int e = fromElement; e < ELEMENTS; e++) {
            for (int i = 0; i < b.count; i++) {
                if (b.inverseInertia[e][i] != 0) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean hasProducts(int slot) {
        return inverseInertia[IXY][slot] != 0
                || inverseInertia[IXZ][slot] != 0
                || inverseInertia[IYZ][slot] != 0;
    }

    /**
     * The inertia of a body whose centre of mass is not its origin, or that has added mass or a
     * mount; empty for any other.
     */
    public @Nullable SpatialInertia spatial(int slot) {
        return spatial[slot];
    }

    /** States the fields of the world, in order of id. */
    public void setFields(List<Field<?>> all) {
        fields = List.copyOf(all);
        currents = fields(Current.class).stream().map(Current::prepared).toList();
    }

    /** The fields of the world, in order of id. */
    public List<Field<?>> fields() {
        return fields;
    }

    /** The fields of a type, in order of id. */
    <F extends Field<?>> List<F> fields(Class<F> type) {
        return fields.stream().filter(type::isInstance).map(type::cast).toList();
    }

    /** How the water moves, on which the velocity of a body with added mass depends. */
    public List<Current> currents() {
        return currents;
    }

    /** States the world's time (s) of the state. */
    public void setTime(double now) {
        time = now;
    }

    /** The world's time (s) of the state. */
    double time() {
        return time;
    }

    /** Velocity of the water (m/s, world) around the body in a slot if it is at a place, now. */
    Vec3 waterAround(int slot, Vec3 position) {
        Vec3 sum = Vec3.ZERO;
        for (Current current : currents) {
            sum = sum.plus(current.feltBy(slot, position, time));
        }
        return sum;
    }

    /** Masses (kg) by slot; 0 for a fixed body. */
    public double[] mass() {
        return mass;
    }

    /** Inverse masses (1/kg) by slot; 0 for a fixed body. */
    public double[] inverseMass() {
        return inverseMass;
    }

    /** Radii (m) of the bounding spheres, by slot. */
    public double[] radius() {
        return radius;
    }

    /** The resultants of named forces and propulsors. */
    public AppliedForces applied() {
        return applied;
    }

    /** The actuators whose push is not constant. */
    public Actuators actuators() {
        return actuators;
    }

    /**
     * Writes the inverse of a body's 6x6 inertia about its origin in the world's axes: row by row
     * the matrix that turns momenta (P, L) into velocities (v, w); zeros for a fixed body.
     *
     * @param to receives 36 numbers from {@code at} on
     */
    public void inverseInertia6(
            int slot, double qw, double qx, double qy, double qz, double[] to, int at) {
        Arrays.fill(to, at, at + 36, 0);
        SpatialInertia general = spatial[slot];
        if (general != null) {
            general.inverse(new Quat(qw, qx, qy, qz), to, at);
            return;
        }
        to[at] = inverseMass[slot];
        to[at + 7] = inverseMass[slot];
        to[at + 14] = inverseMass[slot];
        double rxx = 1 - 2 * (qy * qy + qz * qz);
        double rxy = 2 * (qx * qy - qw * qz);
        double rxz = 2 * (qx * qz + qw * qy);
        double ryx = 2 * (qx * qy + qw * qz);
        double ryy = 1 - 2 * (qx * qx + qz * qz);
        double ryz = 2 * (qy * qz - qw * qx);
        double rzx = 2 * (qx * qz - qw * qy);
        double rzy = 2 * (qy * qz + qw * qx);
        double rzz = 1 - 2 * (qx * qx + qy * qy);
        to[at + 21] = congruent(slot, rxx, rxy, rxz, rxx, rxy, rxz);
        to[at + 28] = congruent(slot, ryx, ryy, ryz, ryx, ryy, ryz);
        to[at + 35] = congruent(slot, rzx, rzy, rzz, rzx, rzy, rzz);
        to[at + 22] = congruent(slot, rxx, rxy, rxz, ryx, ryy, ryz);
        to[at + 23] = congruent(slot, rxx, rxy, rxz, rzx, rzy, rzz);
        to[at + 29] = congruent(slot, ryx, ryy, ryz, rzx, rzy, rzz);
        to[at + 27] = to[at + 22];
        to[at + 33] = to[at + 23];
        to[at + 34] = to[at + 29];
    }

    /** a . I^-1 b, one element of R I^-1 R^T for two rows of R. */
    private double congruent(
            int slot, double ax, double ay, double az, double bx, double by, double bz) {
        double xy = inverseInertia[IXY][slot];
        double xz = inverseInertia[IXZ][slot];
        double yz = inverseInertia[IYZ][slot];
        return ax * (inverseInertia[IXX][slot] * bx + xy * by + xz * bz)
                + ay * (xy * bx + inverseInertia[IYY][slot] * by + yz * bz)
                + az * (xz * bx + yz * by + inverseInertia[IZZ][slot] * bz);
    }

    /** Writes the pose of a body. */
    public void pose(int slot, Pose to) {
        pose(columns, slot, to);
    }

    /** Writes the pose of a body that stands in columns like these. */
    public static void pose(double[][] columns, int slot, Pose to) {
        to.x = columns[X][slot];
        to.y = columns[Y][slot];
        to.z = columns[Z][slot];
        to.qw = columns[QW][slot];
        to.qx = columns[QX][slot];
        to.qy = columns[QY][slot];
        to.qz = columns[QZ][slot];
    }

    /** Adds six numbers to the momenta P, L of a body, but for what a mount takes. */
    public void addMomenta(int slot, double[] impulse, int at) {
        SpatialInertia general = spatial[slot];
        if (general != null && general.free != null) {
            general.free.add(columns, slot, impulse, at);
            return;
        }
        for (int c = 0; inverseMass[slot] != 0 && c < 6; c++) {
            columns[PX + c][slot] += impulse[at + c];
        }
    }

    /** Appends a body at rest at the origin and returns its slot. */
    int add(WorldObjectDefinition definition) {
        if (count == mass.length) {
            grow(2 * count);
        }
        int slot = count++;
        for (double[] column : columns) {
            column[slot] = 0;
        }
        columns[QW][slot] = 1;
        radius[slot] = definition.volume().boundingRadius();
        setConstants(slot, definition);
        spatial[slot] = definition.spatialInertia().orElse(null);
        withSpatial += spatial[slot] == null ? 0 : 1;
        spatialColumns.set(slot, spatial[slot]);
        withProducts += hasProducts(slot) ? 1 : 0;
        fixed += definition.fixed() ? 1 : 0;
        applied.clear(slot);
        actuators.set(slot, List.of());
        return slot;
    }

    private void setConstants(int slot, WorldObjectDefinition definition) {
        if (definition.fixed()) {
            mass[slot] = 0;
            inverseMass[slot] = 0;
            for (double[] element : inverseInertia) {
                element[slot] = 0;
            }
            return;
        }
        MassProperties properties = definition.massProperties().orElseThrow();
        Mat3 inverse = properties.inverseInertia();
        mass[slot] = properties.mass();
        inverseMass[slot] = 1 / properties.mass();
        inverseInertia[IXX][slot] = inverse.xx();
        inverseInertia[IYY][slot] = inverse.yy();
        inverseInertia[IZZ][slot] = inverse.zz();
        inverseInertia[IXY][slot] = inverse.xy();
        inverseInertia[IXZ][slot] = inverse.xz();
        inverseInertia[IYZ][slot] = inverse.yz();
    }

    /** Removes the body in {@code slot}; those behind it move down by one. */
    void remove(int slot) {
        withProducts -= hasProducts(slot) ? 1 : 0;
        withSpatial -= spatial[slot] == null ? 0 : 1;
        System.arraycopy(spatial, slot + 1, spatial, slot, count - slot - 1);
        spatialColumns.remove(slot, count);
        fixed -= inverseMass[slot] == 0 ? 1 : 0;
        for (double[] column : columns) {
            closeGap(column, slot);
        }
        for (double[] element : inverseInertia) {
            closeGap(element, slot);
        }
        closeGap(mass, slot);
        closeGap(inverseMass, slot);
        closeGap(radius, slot);
        applied.remove(slot, count);
        actuators.remove(slot, count);
        count--;
    }

    private void closeGap(double[] array, int slot) {
        System.arraycopy(array, slot + 1, array, slot, count - slot - 1);
    }

    private void grow(int capacity) {
        growAll(columns, capacity);
        growAll(inverseInertia, capacity);
        spatial = Arrays.copyOf(spatial, capacity);
        spatialColumns.grow(capacity);
        mass = Arrays.copyOf(mass, capacity);
        inverseMass = Arrays.copyOf(inverseMass, capacity);
        radius = Arrays.copyOf(radius, capacity);
        applied.grow(capacity);
        actuators.grow(capacity);
    }

    static void growAll(double[][] arrays, int capacity) {
        for (int i = 0; i < arrays.length; i++) {
            arrays[i] = Arrays.copyOf(arrays[i], capacity);
        }
    }
}
