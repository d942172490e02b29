package org.auvsim.viz.jme;

import com.jme3.material.Material;
import com.jme3.renderer.Camera;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.scene.Mesh;
import com.jme3.scene.Spatial.CullHint;
import com.jme3.scene.VertexBuffer;
import com.jme3.scene.instancing.InstancedGeometry;
import com.jme3.util.BufferUtils;

import org.auvsim.core.volume.Pose;

import java.nio.FloatBuffer;

/**
 * Many copies of a mesh in one call to the graphics card, each with its place, turn, sizes and
 * colour; written anew each frame. It grows as it must and makes nothing else.
 */
final class InstanceBatch extends InstancedGeometry {
    private static final int FLOATS = 16;
    private static final int FIRST = 64;

    /** What is flat is as thick as this (m), so that it has a side to be lit. */
    private static final double THIN = 1e-6;

    private final VertexBuffer instances = new VertexBuffer(VertexBuffer.Type.InstanceData);
    private final VertexBuffer[] all = {instances};
    private final float[] one = new float[FLOATS];
    private FloatBuffer data = BufferUtils.createFloatBuffer(FIRST * FLOATS);
    private int count;

    InstanceBatch(String name, Mesh mesh, Material material, Bucket bucket) {
        super(name);
        setMesh(mesh);
        setMaterial(material);
        setQueueBucket(bucket);
        setCullHint(CullHint.Never);
        instances.setInstanced(true);
        instances.setupData(VertexBuffer.Usage.Stream, FLOATS, VertexBuffer.Format.Float, data);
    }

    void begin() {
        data.clear();
        count = 0;
    }

    /** A copy in a pose, its place given from the picture's own origin (m), with three sizes. */
    void add(
            Pose pose,
            double x,
            double y,
            double z,
            double sizeX,
            double sizeY,
            double sizeZ,
            int colour) {
        if (data.remaining() < FLOATS) {
            grow();
        }
        double thick = Math.max(sizeZ, THIN);
        double w = pose.qw;
        double a = pose.qx;
        double b = pose.qy;
        double c = pose.qz;
        column(
                0,
                sizeX * (1 - 2 * (b * b + c * c)),
                sizeX * 2 * (a * b + w * c),
                sizeX * 2 * (a * c - w * b),
                colour >> 16);
        column(
                1,
                sizeY * 2 * (a * b - w * c),
                sizeY * (1 - 2 * (a * a + c * c)),
                sizeY * 2 * (b * c + w * a),
                colour >> 8);
        column(
                2,
                thick * 2 * (a * c + w * b),
                thick * 2 * (b * c - w * a),
                thick * (1 - 2 * (a * a + b * b)),
                colour);
        column(3, x, y, z, colour >> 24);
        data.put(one);
        count++;
    }

    private void column(int i, double x, double y, double z, int shade) {
        one[4 * i] = (float) x;
        one[4 * i + 1] = (float) y;
        one[4 * i + 2] = (float) z;
        one[4 * i + 3] = (shade & 0xff) / 255f;
    }

    private void grow() {
        FloatBuffer larger = BufferUtils.createFloatBuffer(2 * data.capacity());
        data.flip();
        larger.put(data);
        BufferUtils.destroyDirectBuffer(data);
        data = larger;
    }

    void end() {
        data.flip();
        instances.updateData(data);
    }

    @Override
    public int getNumVisibleInstances() {
        return count;
    }

    @Override
    public VertexBuffer[] getAllInstanceData() {
        return all;
    }

    @Override
    public void updateInstances(Camera camera) {
        // There are no geometries behind the instances.
    }
}
