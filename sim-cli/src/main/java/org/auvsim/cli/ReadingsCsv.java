package org.auvsim.cli;

import de.siegmar.fastcsv.writer.CsvWriter;

import org.auvsim.core.entity.Entity;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;

import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;

/** What the sensors of a world read, as CSV: a row for each single value of each reading. */
final class ReadingsCsv implements WorldListener, Closeable {
    private final World world;
    private final CsvWriter csv;
    private long rows;

    /**
     * Writes to {@code out} what it hears of a world, beginning with the header.
     *
     * @throws java.io.UncheckedIOException if that fails, as all other methods
     */
    ReadingsCsv(World world, Writer out) {
        this.world = world;
        csv = CsvWriter.builder().build(out);
        csv.writeRecord("t", "arrived", "object", "sensor", "quantity", "value");
    }

    /** Rows written, the header not counted. */
    long rows() {
        return rows;
    }

    @Override
    public void happened(WorldEvent event) {
        if (event instanceof WorldEvent.SensorRead read) {
            String object =
                    world.find(read.objectId())
                            .map(Entity::name)
                            .orElse(Long.toString(read.objectId()));
            Quantities.of(read.reading())
                    .forEach((quantity, value) -> append(read, object, quantity, value));
        }
    }

    private void append(WorldEvent.SensorRead read, String object, String quantity, String value) {
        csv.writeRecord(
                Double.toString(read.measuredAt()),
                Double.toString(read.time()),
                object,
                read.sensor(),
                quantity,
                value);
        rows++;
    }

    @Override
    public void close() throws IOException {
        csv.close();
    }
}
