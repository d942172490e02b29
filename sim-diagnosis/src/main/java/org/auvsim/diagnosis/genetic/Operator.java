package org.auvsim.diagnosis.genetic;

/** What formulas are built with. */
enum Operator {
    /** a + b. */
    PLUS,
    /** a - b. */
    MINUS,
    /** a * b. */
    TIMES,
    /** sin(a). */
    SINE,
    /** |a|. */
    MAGNITUDE;

    boolean isUnary() {
        return this == SINE || this == MAGNITUDE;
    }

    double of(double a, double b) {
        return switch (this) {
            case PLUS -> a + b;
            case MINUS -> a - b;
            case TIMES -> a * b;
            case SINE -> StrictMath.sin(a);
            case MAGNITUDE -> Math.abs(a);
        };
    }

    String text(String a, String b) {
        return switch (this) {
            case PLUS -> "(" + a + " + " + b + ")";
            case MINUS -> "(" + a + " - " + b + ")";
            case TIMES -> a + " * " + b;
            case SINE -> "sin(" + a + ")";
            case MAGNITUDE -> "|" + a + "|";
        };
    }
}
