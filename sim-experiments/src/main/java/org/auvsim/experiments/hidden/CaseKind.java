package org.auvsim.experiments.hidden;

import java.util.Locale;

/** What is hidden in a case. */
public enum CaseKind {
    /** One effect of the library. */
    SINGLE(0),
    /** Two of them. */
    PAIR(1),
    /** Nothing; in a third of the cases under noise with heavy tails. */
    NULL(2),
    /** One that no cause of the library covers. */
    UNCOVERED(3),
    /** One effect of the library at 0.3 of its strength. */
    WEAK(4),
    /** One effect that the data may or may not tell apart from another one. */
    ALIAS(5);

    private final int number;

    CaseKind(int number) {
        this.number = number;
    }

    /** Under which its cases are drawn: it stays, so that seeds do. */
    int number() {
        return number;
    }

    /** For command lines. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
