package org.auvsim.diagnosis.run;

/** What an actuator or force was told during a run, sample by sample. Immutable. */
public final class Command {
    private final String name;
    private final double[] levels;

    Command(String name, double[] levels) {
        this.name = name;
        this.levels = levels;
    }

    /**
     * The component's name; or that of a force, a dot and the axis of its vector: {@code push.x}
     * (N).
     */
    public String name() {
        return name;
    }

    /**
     * What it was told at a sample, until the next: a level (-1 to 1), an angle (rad), a component
     * of a force (N).
     */
    public double level(int sample) {
        return levels[sample];
    }

    /** Whether it was told something new at a sample. */
    public boolean changesAt(int sample) {
        return sample == 0 || levels[sample] != levels[sample - 1];
    }
}
