package org.auvsim.viz.jme;

import com.jme3.material.Material;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.VertexBuffer;
import com.jme3.util.BufferUtils;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;

/** Lines of a picture in one call to the graphics card; written anew each frame. */
final class LineBatch {
    private static final int FIRST = 1024;

    private final Mesh mesh = new Mesh();
    private final Geometry geometry = new Geometry("lines", mesh);
    private final VertexBuffer ends = new VertexBuffer(VertexBuffer.Type.Position);
    private final VertexBuffer colours = new VertexBuffer(VertexBuffer.Type.Color);
    private FloatBuffer places = BufferUtils.createFloatBuffer(6 * FIRST);
    private ByteBuffer shades = BufferUtils.createByteBuffer(8 * FIRST);

    /** Lines that are painted when what is in a bucket is. */
    LineBatch(Material material, Bucket bucket) {
        mesh.setMode(Mesh.Mode.Lines);
        ends.setupData(VertexBuffer.Usage.Stream, 3, VertexBuffer.Format.Float, places);
        colours.setupData(VertexBuffer.Usage.Stream, 4, VertexBuffer.Format.UnsignedByte, shades);
        colours.setNormalized(true);
        mesh.setBuffer(ends);
        mesh.setBuffer(colours);
        geometry.setMaterial(material);
        geometry.setQueueBucket(bucket);
        geometry.setCullHint(Geometry.CullHint.Never);
    }

    Geometry geometry() {
        return geometry;
    }

    void begin() {
        places.clear();
        shades.clear();
    }

    /** A line between two places, given from the picture's own origin (m). */
    void add(double ax, double ay, double az, double bx, double by, double bz, int colour) {
        if (places.remaining() < 6) {
            grow();
        }
        places.put((float) ax).put((float) ay).put((float) az);
        places.put((float) bx).put((float) by).put((float) bz);
        shade(colour);
        shade(colour);
    }

    private void shade(int colour) {
        shades.put((byte) (colour >> 16)).put((byte) (colour >> 8));
        shades.put((byte) colour).put((byte) (colour >> 24));
    }

    private void grow() {
        FloatBuffer morePlaces = BufferUtils.createFloatBuffer(2 * places.capacity());
        ByteBuffer moreShades = BufferUtils.createByteBuffer(2 * shades.capacity());
        places.flip();
        shades.flip();
        morePlaces.put(places);
        moreShades.put(shades);
        BufferUtils.destroyDirectBuffer(places);
        BufferUtils.destroyDirectBuffer(shades);
        places = morePlaces;
        shades = moreShades;
    }

    void end() {
        places.flip();
        shades.flip();
        ends.updateData(places);
        colours.updateData(shades);
        if (mesh.getVertexCount() != ends.getNumElements()) {
            mesh.updateCounts();
        }
    }
}
