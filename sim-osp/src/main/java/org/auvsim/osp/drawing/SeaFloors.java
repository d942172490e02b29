// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import org.auvsim.core.volume.HeightMap;

import java.util.HashMap;
import java.util.Map;

/** The triangles of height maps, made once each. */
final class SeaFloors {
    /** Of maps with more squares along an edge every second, third ... place is drawn. */
    private static final int MOST = 40;

    /** What is drawn of a map. */
    private record Floor(HeightMap map, Shape shape) {}

    private final Map<Long, Floor> byId = new HashMap<>();

    Shape shape(long id, HeightMap map) {
        Floor known = byId.get(id);
        if (known == null || !known.map().equals(map)) {
            known = new Floor(map, triangles(map));
            byId.put(id, known);
        }
        return known.shape();
    }

    private static Shape triangles(HeightMap map) {
        int rows = map.row().size() - 1;
        int columns = map.row().getFirst().heights().size() - 1;
        int stride = (Math.max(rows, columns) - 1) / MOST + 1;
        int drawnRows = (rows + stride - 1) / stride;
        int drawnColumns = (columns + stride - 1) / stride;
        double[][][] faces = new double[2 * drawnRows * drawnColumns][][];
        int at = 0;
        for (int j = 0; j < rows; j += stride) {
            for (int i = 0; i < columns; i += stride) {
                double[] a = place(map, i, j);
                double[] b = place(map, i + stride, j);
                double[] c = place(map, i + stride, j + stride);
                double[] d = place(map, i, j + stride);
                faces[at++] = new double[][] {a, b, c};
                faces[at++] = new double[][] {a, c, d};
            }
        }
        return new Shape(faces);
    }

    private static double[] place(HeightMap map, int column, int row) {
        int i = Math.min(column, map.row().getFirst().heights().size() - 1);
        int j = Math.min(row, map.row().size() - 1);
        return new double[] {
            i * map.spacing(), j * map.spacing(), map.row().get(j).heights().get(i)
        };
    }
}
