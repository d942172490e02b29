package org.auvsim.checks.offender.server;

import java.util.logging.Logger;

final class Talks {
    private Talks() {}

    static void toTheConsole() {
        System.out.println("hello");
    }

    static void toTheErrorStream(Exception e) {
        e.printStackTrace();
    }

    static void toTheLogOfTheJdk() {
        Logger.getLogger("hello").info("hello");
    }
}
