package org.auvsim.cli.export;

import java.io.Closeable;
import java.io.IOException;

/** Takes the rows of all tables; what it makes is whole when it has been closed. */
interface TableWriter extends Closeable {
    void append(Table table, Row row) throws IOException;
}
