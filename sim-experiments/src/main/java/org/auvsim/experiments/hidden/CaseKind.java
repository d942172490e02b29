package org.auvsim.experiments.hidden;

import java.util.Locale;

/** What is hidden in a case. */
public enum CaseKind {
    /** One effect of the library. */
    SINGLE,
    /** Two of them. */
    PAIR,
    /** Nothing; in a third of the cases under noise with heavy tails. */
    NULL,
    /** One that no cause of the library covers. */
    UNCOVERED,
    /** One effect of the library at 0.3 of its strength. */
    WEAK,
    /** One effect that the data may or may not tell apart from another one. */
    ALIAS;

    /** For command lines. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
