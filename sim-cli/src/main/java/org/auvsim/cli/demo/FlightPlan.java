package org.auvsim.cli.demo;

import java.util.ArrayList;
import java.util.List;

/**
 * What the pilot does and when: four legs of a square, flown open loop, each a push, a coast, a
 * brake and a turn to port that would be a quarter turn without drag.
 */
final class FlightPlan {
    /** From {@code at} (s) on the thrusters run at these levels, -1 to 1. */
    record Setting(double at, double port, double starboard, double ventral) {}

    /** How long a round is (s). */
    static final double DURATION = 56;

    private static final double LEG = 14;
    private static final int LEGS = 4;
    private static final double PUSH = 0.3;
    private static final double TURN = 0.2048;

    private final List<Setting> settings = new ArrayList<>();

    /** Once round. */
    FlightPlan() {
        this(1);
    }

    /** So many times round. */
    FlightPlan(int rounds) {
        for (int leg = 0; leg < LEGS * rounds; leg++) {
            double start = leg * LEG;
            double climb = leg % LEGS < LEGS / 2 ? 0.05 : -0.05;
            settings.add(new Setting(start, PUSH, PUSH, climb));
            settings.add(new Setting(start + 2, 0, 0, 0));
            settings.add(new Setting(start + 8, -PUSH, -PUSH, -climb));
            settings.add(new Setting(start + 10, -TURN, TURN, 0));
            settings.add(new Setting(start + 11.8, TURN, -TURN, 0));
            settings.add(new Setting(start + 13.6, 0, 0, 0));
        }
    }

    List<Setting> settings() {
        return settings;
    }

    /** The setting that holds at a time (s). */
    Setting at(double time) {
        Setting holding = settings.getFirst();
        for (Setting setting : settings) {
            if (setting.at() <= time + 1e-9) {
                holding = setting;
            }
        }
        return holding;
    }
}
