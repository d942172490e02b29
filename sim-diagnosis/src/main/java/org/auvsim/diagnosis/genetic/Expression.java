package org.auvsim.diagnosis.genetic;

import java.util.List;
import java.util.Locale;

/** A formula as a tree. Immutable. */
sealed interface Expression {
    /** Its value where the variables have these. */
    double at(double[] variables);

    /** How many nodes it has. */
    int size();

    /** As people write it. */
    String text();

    /** What it is made of. */
    List<Expression> parts();

    /** The same made of other parts, as many. */
    Expression of(List<Expression> others);

    /** One of what is known at a sample. */
    record Variable(int index) implements Expression {
        /** Names of the variables: time (s), position (m), velocity (m/s), angles (rad). */
        static final List<String> NAMES =
                List.of("t", "x", "y", "z", "vx", "vy", "vz", "roll", "pitch", "yaw");

        @Override
        public double at(double[] variables) {
            return variables[index];
        }

        @Override
        public int size() {
            return 1;
        }

        @Override
        public String text() {
            return NAMES.get(index);
        }

        @Override
        public List<Expression> parts() {
            return List.of();
        }

        @Override
        public Expression of(List<Expression> others) {
            return this;
        }
    }

    /** A number. */
    record Constant(double value) implements Expression {
        @Override
        public double at(double[] variables) {
            return value;
        }

        @Override
        public int size() {
            return 1;
        }

        @Override
        public String text() {
            return text(value, 4);
        }

        /** So many digits of a number, a negative one in brackets. */
        static String text(double value, int digits) {
            String text = String.format(Locale.ROOT, "%." + digits + "g", value);
            return text.startsWith("-") ? "(" + text + ")" : text;
        }

        @Override
        public List<Expression> parts() {
            return List.of();
        }

        @Override
        public Expression of(List<Expression> others) {
            return this;
        }
    }

    /** One of the operators on one or two parts. */
    record Operation(Operator operator, List<Expression> parts) implements Expression {
        @Override
        public double at(double[] variables) {
            double first = parts.getFirst().at(variables);
            return operator.of(first, operator.isUnary() ? 0 : parts.getLast().at(variables));
        }

        @Override
        public int size() {
            return 1 + parts.stream().mapToInt(Expression::size).sum();
        }

        @Override
        public String text() {
            return operator.text(parts.getFirst().text(), parts.getLast().text());
        }

        @Override
        public Expression of(List<Expression> others) {
            return new Operation(operator, List.copyOf(others));
        }
    }
}
