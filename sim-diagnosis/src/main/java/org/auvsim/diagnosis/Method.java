package org.auvsim.diagnosis;

import java.util.Locale;

/** How causes are searched for; the same rules judge what either finds. */
public enum Method {
    /** By the columns that causes leave along the measured motion (multiple shooting). */
    SHOOTING,
    /** By a population of models that compete side by side (thesis, section 9.4). */
    GENETIC;

    /** As a command line and a file have it. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
