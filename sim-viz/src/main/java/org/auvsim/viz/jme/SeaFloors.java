package org.auvsim.viz.jme;

import com.jme3.material.Material;
import com.jme3.renderer.queue.RenderQueue.Bucket;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;

import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Pose;

import java.util.HashMap;
import java.util.Map;

/** The meshes of height maps, made once each. */
final class SeaFloors {
    /** More places than this along an edge are not drawn: every second, third ... is. */
    private static final int MOST = 400;

    /** What is drawn of a map. */
    private record Floor(HeightMap map, InstanceBatch batch) {}

    private final Material material;
    private final Node node;
    private final Map<Long, Floor> byId = new HashMap<>();

    SeaFloors(Material material, Node node) {
        this.material = material;
        this.node = node;
    }

    void begin() {
        byId.values().forEach(floor -> floor.batch().begin());
    }

    void add(long id, HeightMap map, Pose pose, double x, double y, double z, int colour) {
        Floor floor = byId.get(id);
        if (floor == null || !floor.map().equals(map)) {
            if (floor != null) {
                node.detachChild(floor.batch());
            }
            floor =
                    new Floor(
                            map,
                            new InstanceBatch("sea floor", mesh(map), material, Bucket.Opaque));
            floor.batch().begin();
            byId.put(id, floor);
            node.attachChild(floor.batch());
        }
        floor.batch().add(pose, x, y, z, 1, 1, 1, colour);
    }

    void end() {
        byId.values().forEach(floor -> floor.batch().end());
    }

    private static Mesh mesh(HeightMap map) {
        int rows = map.row().size();
        int columns = map.row().getFirst().heights().size();
        int stride = (Math.max(rows, columns) - 1) / MOST + 1;
        int drawnRows = (rows - 1) / stride + 1;
        int drawnColumns = (columns - 1) / stride + 1;
        float[] places = new float[3 * drawnRows * drawnColumns];
        float[] normals = new float[places.length];
        int at = 0;
        for (int j = 0; j < drawnRows; j++) {
            for (int i = 0; i < drawnColumns; i++) {
                places[at] = (float) (i * stride * map.spacing());
                places[at + 1] = (float) (j * stride * map.spacing());
                places[at + 2] = (float) height(map, i * stride, j * stride);
                normals[at] = (float) -slope(map, i * stride, j * stride, stride, 0);
                normals[at + 1] = (float) -slope(map, i * stride, j * stride, 0, stride);
                normals[at + 2] = 1;
                at += 3;
            }
        }
        return UnitMeshes.mesh(places, normals, UnitMeshes.grid(drawnRows - 1, drawnColumns - 1));
    }

    private static double slope(HeightMap map, int i, int j, int di, int dj) {
        double rise = height(map, i + di, j + dj) - height(map, i - di, j - dj);
        return rise / (2 * map.spacing() * (di + dj));
    }

    private static double height(HeightMap map, int i, int j) {
        int row = Math.clamp(j, 0, map.row().size() - 1);
        int column = Math.clamp(i, 0, map.row().getFirst().heights().size() - 1);
        return map.row().get(row).heights().get(column);
    }
}
