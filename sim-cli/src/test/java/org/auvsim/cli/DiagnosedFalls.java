package org.auvsim.cli;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** A ball that falls, and {@code auvsim diagnose} of what was measured of it. */
abstract class DiagnosedFalls {
    static final double GRAVITY = 9.80665;

    static final String BALL =
            """
            <scenario>
              <time-step delta="0.05"/>
              <world-object name="Ball" mass="0.5"><sphere radius="0.1"/><gravity/></world-object>
            </scenario>
            """;

    @TempDir Path folder;
    CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    int diagnose(String model, Object... options) throws IOException {
        List<Object> arguments = new ArrayList<>();
        arguments.addAll(List.of("diagnose", "--scenario", auvsim.file("model.xml", model)));
        arguments.addAll(List.of(options));
        return auvsim.run(arguments.toArray());
    }

    /** Two falls that are fitted and one that is held out, all swaying so far (m). */
    int diagnoseFalls(String model, double sway, Object... options) throws IOException {
        List<Object> arguments = new ArrayList<>(List.of(options));
        arguments.addAll(List.of("--fit", fall("one.csv", 0, sway), fall("two.csv", 1, sway)));
        arguments.addAll(List.of("--holdout", fall("three.csv", 2, sway)));
        return diagnose(model, arguments.toArray());
    }

    /** 2 s of a ball in vacuum that is thrown by lot, seen with 5 mm of noise. */
    Path fall(String name, long seed) throws IOException {
        return fall(name, seed, 0);
    }

    /** The same, swaying once a second, so far (m) to each side. */
    Path fall(String name, long seed, double sway) throws IOException {
        Random lot = new Random(seed);
        double vx = lot.nextDouble(-3, 3);
        double vy = lot.nextDouble(-3, 3);
        double vz = lot.nextDouble(0, 5);
        StringBuilder text = new StringBuilder("t,x,y,z\n");
        for (int i = 0; i <= 60; i++) {
            double t = i / 30.0;
            text.append(
                    String.format(
                            Locale.ROOT,
                            "%.6f,%.5f,%.5f,%.5f%n",
                            t,
                            vx * t + sway * Math.sin(2 * Math.PI * t) + lot.nextGaussian(0, 0.005),
                            vy * t + lot.nextGaussian(0, 0.005),
                            20 + vz * t - GRAVITY * t * t / 2 + lot.nextGaussian(0, 0.005)));
        }
        return auvsim.file(name, text.toString());
    }
}
