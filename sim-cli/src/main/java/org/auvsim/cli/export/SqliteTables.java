package org.auvsim.cli.export;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.sql.Statement;
import java.sql.Types;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** The tables of an SQLite database, filled in one transaction. */
final class SqliteTables implements TableWriter {
    private final Connection database;
    private final Map<Table, PreparedStatement> inserts = new EnumMap<>(Table.class);

    /** Makes the tables in a file, which is empty. */
    SqliteTables(Path file) throws IOException {
        try {
            database = DriverManager.getConnection("jdbc:sqlite:" + file.toAbsolutePath());
        } catch (SQLException e) {
            throw trouble(e);
        }
        try {
            database.setAutoCommit(false);
            for (Table table : Table.values()) {
                create(table);
            }
        } catch (SQLException e) {
            IOException trouble = trouble(e);
            try {
                database.close();
            } catch (SQLException closing) {
                trouble.addSuppressed(closing);
            }
            throw trouble;
        }
    }

    private void create(Table table) throws SQLException {
        String columns =
                table.columns().stream()
                        .map(column -> column.name() + " " + column.type())
                        .collect(Collectors.joining(", "));
        try (Statement statement = database.createStatement()) {
            statement.execute("CREATE TABLE %s (%s)".formatted(table.sqlName(), columns));
        }
        String values = String.join(", ", Collections.nCopies(table.columns().size(), "?"));
        inserts.put(
                table,
                database.prepareStatement(
                        "INSERT INTO %s VALUES (%s)".formatted(table.sqlName(), values)));
    }

    @Override
    public void append(Table table, Row row) throws IOException {
        PreparedStatement insert = requireNonNull(inserts.get(table));
        List<Optional<Object>> cells = row.cells();
        try {
            for (int i = 0; i < cells.size(); i++) {
                if (cells.get(i).isPresent()) {
                    insert.setObject(i + 1, cells.get(i).get());
                } else {
                    insert.setNull(i + 1, Types.NULL);
                }
            }
            insert.executeUpdate();
        } catch (SQLException e) {
            throw trouble(e);
        }
    }

    @Override
    public void close() throws IOException {
        try (database) {
            for (PreparedStatement insert : inserts.values()) {
                insert.close();
            }
            database.commit();
        } catch (SQLException e) {
            throw trouble(e);
        }
    }

    private static IOException trouble(SQLException e) {
        return new IOException(e.getMessage(), e);
    }
}
