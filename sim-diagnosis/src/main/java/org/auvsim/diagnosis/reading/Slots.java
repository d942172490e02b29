package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.run.Channel;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The places of a row's numbers, by the usual names of their columns. */
final class Slots {
    /** Of a column that fills no place. */
    static final int NOWHERE = -1;

    static final int TIME = 0;
    static final int POSITION = 1;
    static final int QUATERNION = 4;
    static final int ANGLES = 8;
    static final int VELOCITY = 11;
    static final int ANGULAR_VELOCITY = 14;

    /** Three for each channel, in their order. */
    static final int DEVIATIONS = 17;

    /** The number of the run that a row is of. */
    static final int RUN = DEVIATIONS + 3 * Channel.values().length;

    /** What tells of shaking: an acceleration, then an angular rate. */
    static final int SHAKING = RUN + 1;

    /** From here on, one each. */
    static final int COMMANDS = SHAKING + 2;

    static final String TIME_NAME = "t";
    private static final String RUN_NAME = "run";
    static final String DEPTH_NAME = "depth";

    /** Velocities in the world's axes and in the body's, then angular velocities in both. */
    static final List<String> VX = List.of("vx", "vy", "vz");

    static final List<String> U = List.of("u", "v", "w");
    static final List<String> WX = List.of("wx", "wy", "wz");
    static final List<String> P = List.of("p", "q", "r");
    static final List<String> QUATERNION_NAMES = List.of("qw", "qx", "qy", "qz");
    static final List<String> ANGLE_NAMES = List.of("roll", "pitch", "yaw");
    private static final String DEVIATION = "sd_";

    private static final Map<String, Integer> BY_NAME = new LinkedHashMap<>();

    static {
        put(TIME, List.of(TIME_NAME));
        put(RUN, List.of(RUN_NAME));
        put(POSITION, List.of("x", "y", "z"));
        put(POSITION + 2, List.of(DEPTH_NAME));
        put(QUATERNION, QUATERNION_NAMES);
        put(ANGLES, ANGLE_NAMES);
        put(VELOCITY, VX);
        put(VELOCITY, U);
        put(ANGULAR_VELOCITY, WX);
        put(ANGULAR_VELOCITY, P);
        for (Channel channel : Channel.values()) {
            int slot = deviation(channel);
            List.copyOf(BY_NAME.entrySet()).stream()
                    .filter(e -> measuredBy(channel) <= e.getValue())
                    .filter(e -> e.getValue() < measuredBy(channel) + 3)
                    .forEach(
                            e ->
                                    BY_NAME.put(
                                            DEVIATION + e.getKey(),
                                            slot + e.getValue() - measuredBy(channel)));
        }
    }

    private Slots() {}

    private static void put(int first, List<String> names) {
        for (int i = 0; i < names.size(); i++) {
            BY_NAME.put(names.get(i), first + i);
        }
    }

    /** The first of a channel's three; of orientations it is that of the angles. */
    static int measuredBy(Channel channel) {
        return switch (channel) {
            case POSITION -> POSITION;
            case ORIENTATION -> ANGLES;
            case VELOCITY -> VELOCITY;
            case ANGULAR_VELOCITY -> ANGULAR_VELOCITY;
        };
    }

    /** The first of a channel's three deviations. */
    static int deviation(Channel channel) {
        return switch (channel) {
            case POSITION -> DEVIATIONS;
            case ORIENTATION -> DEVIATIONS + 3;
            case VELOCITY -> DEVIATIONS + 6;
            case ANGULAR_VELOCITY -> DEVIATIONS + 9;
        };
    }

    /** Places by name. */
    static Map<String, Integer> byName() {
        return BY_NAME;
    }

    /** Whether what has this place is an angle or its rate. */
    static boolean isAngular(int slot) {
        return within(slot, ANGLES, 3)
                || within(slot, ANGULAR_VELOCITY, 3)
                || within(slot, deviation(Channel.ORIENTATION), 3)
                || within(slot, deviation(Channel.ANGULAR_VELOCITY), 3);
    }

    /** Whether what has this place is measured: no time, deviation or command. */
    static boolean isMeasured(int slot) {
        return POSITION <= slot && slot < DEVIATIONS;
    }

    static boolean isDeviation(int slot) {
        return within(slot, DEVIATIONS, RUN - DEVIATIONS);
    }

    private static boolean within(int slot, int first, int count) {
        return first <= slot && slot < first + count;
    }
}
