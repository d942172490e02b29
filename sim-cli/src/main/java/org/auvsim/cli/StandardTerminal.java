package org.auvsim.cli;

import java.io.Console;

/** Whether somebody sits there. */
final class StandardTerminal {
    private StandardTerminal() {}

    /** Java 25 has no console, as before 22, where input or output is no terminal. */
    @SuppressWarnings("SystemConsoleNull")
    static boolean isThere() {
        Console console = System.console();
        return console != null && console.isTerminal();
    }
}
