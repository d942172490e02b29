package org.auvsim.viz.jme;

import com.jme3.asset.AssetManager;
import com.jme3.material.Material;
import com.jme3.material.RenderState.BlendMode;
import com.jme3.material.RenderState.FaceCullMode;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;

import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Pose;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.Brush;

import java.util.ArrayList;
import java.util.List;

/**
 * Collects a frame's shapes into a few batches. Places are counted from what the camera looks at,
 * so that single precision is enough however far from the world's origin that is. The camera may
 * move on while a frame is painted: the frame's own origin is what counts.
 */
final class JmeBrush implements Brush {
    /** Cuts of balls, sides of tubes and cones: the more, the more pixels their radius takes. */
    private static final int[] CUTS = {0, 1, 2, 3};

    private static final int[] SIDES = {4, 8, 16, 32};

    /** A shape of so many pixels' radius is painted coarser than those that follow. */
    private static final double[] PIXELS = {4, 20, 60};

    private static final int OPAQUE = 0xff;

    private final Node node = new Node("scene");
    private final List<InstanceBatch> batches = new ArrayList<>();
    private final InstanceBatch[][] balls = new InstanceBatch[CUTS.length][];
    private final InstanceBatch[][] tubes = new InstanceBatch[SIDES.length][];
    private final InstanceBatch[][] cones = new InstanceBatch[SIDES.length][];
    private final InstanceBatch[] cubes;
    private final LineBatch lines;

    /** Those that nothing hides. */
    private final LineBatch linesBefore;

    private final Labels labels;
    private final SeaFloors seaFloors;
    private final double[] pixel = new double[3];
    private final OrbitCamera camera;
    private final double[] origin = new double[3];
    private int width;
    private int height;

    JmeBrush(AssetManager assets, OrbitCamera camera) {
        this.camera = camera;
        // Of what is closed only the outside is seen.
        Material solid = new Material(assets, "org/auvsim/viz/jme/Solid.j3md");
        Material clear = clear(solid);
        Material open = solid.clone();
        open.getAdditionalRenderState().setFaceCullMode(FaceCullMode.Off);
        Material clearOpen = clear(open);
        Material line = new Material(assets, "org/auvsim/viz/jme/Line.j3md");
        line.getAdditionalRenderState().setBlendMode(BlendMode.Alpha);
        line.getAdditionalRenderState().setDepthWrite(false);
        for (int i = 0; i < CUTS.length; i++) {
            balls[i] = both("balls", UnitMeshes.ball(CUTS[i]), solid, clear);
            tubes[i] = both("tubes", UnitMeshes.tube(SIDES[i]), open, clearOpen);
            cones[i] = both("cones", UnitMeshes.cone(SIDES[i]), open, clearOpen);
        }
        cubes = both("cubes", UnitMeshes.cube(), solid, clear);
        Material before = line.clone();
        before.getAdditionalRenderState().setDepthTest(false);
        lines = new LineBatch(line, Bucket.Transparent);
        linesBefore = new LineBatch(before, Bucket.Translucent);
        node.attachChild(lines.geometry());
        node.attachChild(linesBefore.geometry());
        labels =
                new Labels(
                        assets.loadFont("Interface/Fonts/Default.fnt"),
                        new Material(assets, "Common/MatDefs/Gui/Gui.j3md"));
        seaFloors = new SeaFloors(open, node);
    }

    private static Material clear(Material solid) {
        Material clear = solid.clone();
        clear.getAdditionalRenderState().setBlendMode(BlendMode.Alpha);
        clear.getAdditionalRenderState().setDepthWrite(false);
        return clear;
    }

    /** A batch of what is opaque, and one of what is not. */
    private InstanceBatch[] both(String name, Mesh mesh, Material solid, Material clear) {
        return new InstanceBatch[] {
            batch(name, mesh, solid, Bucket.Opaque),
            batch("clear " + name, mesh, clear, Bucket.Transparent)
        };
    }

    private InstanceBatch batch(String name, Mesh mesh, Material material, Bucket bucket) {
        InstanceBatch batch = new InstanceBatch(name, mesh, material, bucket);
        batches.add(batch);
        node.attachChild(batch);
        return batch;
    }

    /** What stands in the world. */
    Node node() {
        return node;
    }

    /** What stands on the picture. */
    Node words() {
        return labels.node();
    }

    /** Begins a frame of so many pixels. */
    void begin(int wide, int high) {
        width = wide;
        height = high;
        for (int axis = 0; axis < origin.length; axis++) {
            origin[axis] = camera.target(axis);
        }
        for (int i = 0; i < batches.size(); i++) {
            batches.get(i).begin();
        }
        lines.begin();
        linesBefore.begin();
        labels.begin();
        seaFloors.begin();
    }

    /** Coordinate {@code axis} of the place that is the origin of this frame (m, world). */
    double origin(int axis) {
        return origin[axis];
    }

    /** Ends a frame: what was collected will be seen. */
    void end() {
        for (int i = 0; i < batches.size(); i++) {
            batches.get(i).end();
        }
        lines.end();
        linesBefore.end();
        labels.end();
        seaFloors.end();
    }

    private static int kind(int colour) {
        return colour >>> 24 == OPAQUE ? 0 : 1;
    }

    private void add(InstanceBatch batch, Pose pose, double x, double y, double z, int colour) {
        batch.add(
                pose, pose.x - origin[0], pose.y - origin[1], pose.z - origin[2], x, y, z, colour);
    }

    @Override
    public void ball(Pose pose, double radius, int colour) {
        add(balls[detail(pose, radius)][kind(colour)], pose, radius, radius, radius, colour);
    }

    /** How fine something of this radius (m) has to be. */
    private int detail(Pose pose, double radius) {
        camera.project(pose.x, pose.y, pose.z, width, height, pixel);
        double pixels = radius * camera.pixelsPerMetre(pixel[2], height);
        int detail = 0;
        while (detail < PIXELS.length && pixels > PIXELS[detail]) {
            detail++;
        }
        return detail;
    }

    @Override
    public void box(Pose pose, double x, double y, double z, int colour) {
        add(cubes[kind(colour)], pose, x, y, z, colour);
    }

    @Override
    public void tube(Pose pose, double length, double radius, int colour) {
        add(tubes[detail(pose, radius)][kind(colour)], pose, length, radius, radius, colour);
    }

    @Override
    public void cone(Pose pose, double length, double radius, int colour) {
        add(cones[detail(pose, radius)][kind(colour)], pose, length, radius, radius, colour);
    }

    @Override
    public void line(double ax, double ay, double az, double bx, double by, double bz, int colour) {
        add(lines, ax, ay, az, bx, by, bz, colour);
    }

    @Override
    public void lineBefore(
            double ax, double ay, double az, double bx, double by, double bz, int colour) {
        add(linesBefore, ax, ay, az, bx, by, bz, colour);
    }

    private void add(
            LineBatch to,
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            int colour) {
        to.add(
                ax - origin[0],
                ay - origin[1],
                az - origin[2],
                bx - origin[0],
                by - origin[1],
                bz - origin[2],
                colour);
    }

    @Override
    public void surface(long id, HeightMap map, Pose pose, int colour) {
        seaFloors.add(
                id, map, pose, pose.x - origin[0], pose.y - origin[1], pose.z - origin[2], colour);
    }

    @Override
    public void label(double x, double y, double z, String text, int colour) {
        camera.project(x, y, z, width, height, pixel);
        boolean seen =
                (pixel[2] > 0 || !camera.isPerspective())
                        && pixel[0] > 0
                        && pixel[0] < width
                        && pixel[1] > 0
                        && pixel[1] < height;
        if (seen) {
            labels.add(pixel[0], height - pixel[1], text, colour, width, height);
        }
    }

    @Override
    public double letters() {
        return Label.SIZE / Math.max(1, height);
    }
}
