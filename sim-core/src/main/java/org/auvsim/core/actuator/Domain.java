package org.auvsim.core.actuator;

/** Refuses parameters outside their ranges, by name. */
final class Domain {
    private final String whose;

    /** For the parameters of an actuator, as in "propulsor 'Port'". */
    Domain(String kind, String name) {
        whose = kind + " '" + name + "'";
    }

    void require(boolean inRange, String what, double value, String range, String unit) {
        if (!inRange || !Double.isFinite(value)) {
            throw new IllegalArgumentException(
                    "%s of %s must be %s, but is %s %s"
                            .formatted(what, whose, range, value, unit)
                            .stripTrailing());
        }
    }
}
