package org.auvsim.cli.export;

/**
 * A column of a table.
 *
 * @param type in SQL
 */
record Column(String name, String type) {
    static Column integer(String name) {
        return new Column(name, "INTEGER");
    }

    static Column real(String name) {
        return new Column(name, "REAL");
    }

    static Column text(String name) {
        return new Column(name, "TEXT");
    }
}
