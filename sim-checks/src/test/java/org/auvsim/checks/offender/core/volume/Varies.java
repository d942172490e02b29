package org.auvsim.checks.offender.core.volume;

import java.nio.file.Path;
import java.util.Random;

final class Varies {
    private Varies() {}

    static double sine(double x) {
        return Math.sin(x);
    }

    static double time() {
        return System.nanoTime() + System.currentTimeMillis();
    }

    static double chance() {
        return new Random().nextDouble();
    }

    static Thread thread() {
        return Thread.ofVirtual().unstarted(() -> {});
    }

    static Path file() {
        return Path.of("file");
    }
}
