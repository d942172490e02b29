package org.auvsim.viz.jme;

import com.jme3.scene.Mesh;
import com.jme3.scene.VertexBuffer;
import com.jme3.util.BufferUtils;

/** Shapes of size one, which instances stretch, turn and move. */
final class UnitMeshes {
    private UnitMeshes() {}

    /** A ball of radius 1: an icosahedron whose faces are cut into four, so many times. */
    static Mesh ball(int cuts) {
        Icosphere ball = Icosphere.of(cuts);
        return mesh(ball.places(), ball.places(), ball.corners());
    }

    /** The side of a cylinder of radius and length 1 about the x axis, its middle at the origin. */
    static Mesh tube(int sides) {
        return side(sides, -0.5f, 0.5f, 1, 0);
    }

    /** A cone of radius and length 1 about the x axis, its base at the origin. */
    static Mesh cone(int sides) {
        return side(sides, 0, 1, 0, 1);
    }

    /** A ring of radius 1 at {@code from}, one of radius {@code tip} at {@code to}. */
    private static Mesh side(int sides, float from, float to, float tip, float slope) {
        float[] places = new float[6 * (sides + 1)];
        float[] normals = new float[6 * (sides + 1)];
        for (int j = 0; j <= sides; j++) {
            float y = (float) Math.cos(2 * Math.PI * j / sides);
            float z = (float) Math.sin(2 * Math.PI * j / sides);
            write(places, j, from, y, z);
            write(places, sides + 1 + j, to, tip * y, tip * z);
            write(normals, j, slope, y, z);
            write(normals, sides + 1 + j, slope, y, z);
        }
        return mesh(places, normals, grid(1, sides));
    }

    private static void write(float[] to, int i, float x, float y, float z) {
        to[3 * i] = x;
        to[3 * i + 1] = y;
        to[3 * i + 2] = z;
    }

    /** A cube with edges of length 1 about the origin. */
    static Mesh cube() {
        float[] places = new float[72];
        float[] normals = new float[72];
        int[] corners = new int[36];
        for (int face = 0; face < 6; face++) {
            int axis = face / 2;
            float out = face % 2 == 0 ? -0.5f : 0.5f;
            for (int k = 0; k < 4; k++) {
                int at = 3 * (4 * face + k);
                places[at + axis] = out;
                places[at + (axis + 1) % 3] = (k & 1) - 0.5f;
                places[at + (axis + 2) % 3] = (k >> 1) - 0.5f;
                normals[at + axis] = 2 * out;
            }
            int[] square = {0, 1, 2, 2, 1, 3};
            for (int k = 0; k < 6; k++) {
                corners[6 * face + k] = 4 * face + square[k];
            }
        }
        return mesh(places, normals, corners);
    }

    /** Triangles over a grid of {@code rows} by {@code columns} squares. */
    static int[] grid(int rows, int columns) {
        int[] corners = new int[6 * rows * columns];
        int at = 0;
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                int here = i * (columns + 1) + j;
                int below = here + columns + 1;
                corners[at++] = here;
                corners[at++] = below;
                corners[at++] = here + 1;
                corners[at++] = here + 1;
                corners[at++] = below;
                corners[at++] = below + 1;
            }
        }
        return corners;
    }

    /** A mesh whose triangles run counter-clockwise, seen from where their normals point. */
    static Mesh mesh(float[] places, float[] normals, int[] corners) {
        for (int i = 0; i < corners.length; i += 3) {
            if (outward(places, normals, corners, i) < 0) {
                int swapped = corners[i + 1];
                corners[i + 1] = corners[i + 2];
                corners[i + 2] = swapped;
            }
        }
        Mesh mesh = new Mesh();
        mesh.setBuffer(VertexBuffer.Type.Position, 3, BufferUtils.createFloatBuffer(places));
        mesh.setBuffer(VertexBuffer.Type.Normal, 3, BufferUtils.createFloatBuffer(normals));
        mesh.setBuffer(VertexBuffer.Type.Index, 3, BufferUtils.createIntBuffer(corners));
        mesh.setStatic();
        mesh.updateBound();
        return mesh;
    }

    /**
     * How much the turn of a triangle's corners, from {@code corners[i]} on, agrees with its
     * normals.
     */
    private static double outward(float[] places, float[] normals, int[] corners, int i) {
        int a = 3 * corners[i];
        int b = 3 * corners[i + 1];
        int c = 3 * corners[i + 2];
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            int y = (axis + 1) % 3;
            int z = (axis + 2) % 3;
            double cross =
                    (places[b + y] - places[a + y]) * (places[c + z] - places[a + z])
                            - (places[b + z] - places[a + z]) * (places[c + y] - places[a + y]);
            sum += cross * (normals[a + axis] + normals[b + axis] + normals[c + axis]);
        }
        return sum;
    }
}
