package org.auvsim.checks.offender.server;

final class Sleeps {
    private Sleeps() {}

    static void aWhile() throws InterruptedException {
        Thread.sleep(1);
    }
}
