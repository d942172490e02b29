package org.auvsim.cli;

import de.siegmar.fastcsv.writer.CsvWriter;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;

import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;

/**
 * What moves in a world, as CSV: a row for each object that is not fixed, whenever {@link #append}
 * is called. Metres and seconds, world axes.
 */
final class TrajectoryCsv implements Closeable {
    private final CsvWriter csv;
    private long rows;

    /**
     * Writes to {@code out}, beginning with the header.
     *
     * @throws java.io.UncheckedIOException if that fails, as all other methods
     */
    TrajectoryCsv(Writer out) {
        csv = CsvWriter.builder().build(out);
        csv.writeRecord(
                "t", "object", "x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy",
                "wz");
    }

    /** Rows written, the header not counted. */
    long rows() {
        return rows;
    }

    void append(World world) {
        String time = Double.toString(world.time());
        for (WorldObject object : world.objects()) {
            if (!object.isFixed()) {
                append(time, object);
            }
        }
    }

    private void append(String time, WorldObject object) {
        Vec3 p = object.position();
        Quat q = object.orientation();
        Vec3 v = object.velocity();
        Vec3 w = object.angularVelocity();
        double[] numbers = {
            p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), w.x(), w.y(),
            w.z()
        };
        List<String> row = new ArrayList<>(List.of(time, object.name()));
        for (double number : numbers) {
            row.add(Double.toString(number));
        }
        csv.writeRecord(row);
        rows++;
    }

    @Override
    public void close() throws IOException {
        csv.close();
    }
}
