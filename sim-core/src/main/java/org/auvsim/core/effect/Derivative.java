package org.auvsim.core.effect;

import org.auvsim.core.entity.Domain;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A hydrodynamic derivative (SNAME 1950), named as it is published: the letter of the force or
 * torque X Y Z K M N, then those of one or two of the velocities u v w p q r. {@code Yv|v|} times v
 * |v| is a sway force, {@code Nuv} times u v a yaw torque, {@code Zq} times q a heave force.
 *
 * @param value in the units that make a force (N) or torque (N m) of it; negative where it damps
 */
public record Derivative(String name, double value) {
    private static final String FORCES = "XYZKMN";
    private static final String VELOCITIES = "uvwpqr";
    private static final Pattern NAME =
            Pattern.compile("([XYZKMN])([uvwpqr])(?:([uvwpqr])|\\|([uvwpqr])\\|)?");

    /**
     * The term without its coefficient: force or torque, first velocity, second one or size. Of a
     * product of two velocities the first is that of the lower axis, as u v is v u.
     */
    record Form(int force, int first, Second kind, int second) {
        /** The number -1 where the axes y, z of the reference are turned over, else 1. */
        int signIn(ReferenceAxes axes) {
            boolean flips =
                    turnsOver(force)
                            ^ turnsOver(first)
                            ^ (kind == Second.SIGNED && turnsOver(second));
            return axes == ReferenceAxes.FRD && flips ? -1 : 1;
        }

        private static boolean turnsOver(int axis) {
            return axis % 3 != 0;
        }
    }

    /** What the first velocity is multiplied by beside the coefficient. */
    enum Second {
        NONE,
        SIGNED,
        SIZE
    }

    /**
     * A checked derivative.
     *
     * @throws IllegalArgumentException if its name is not one, or its value not finite
     */
    public Derivative {
        Matcher match = NAME.matcher(name);
        if (!match.matches()) {
            throw new IllegalArgumentException(
                    ("a hydrodynamic derivative is named by its force or torque (X Y Z K M N) and"
                         + " one or two velocities (u v w p q r), the second one between bars where"
                         + " its size counts, as Yv|v|, Nuv or Zq; '%s' is not; added mass (Yvdot)"
                         + " and fins (Yuudr) have elements of their own")
                            .formatted(name));
        }
        Domain.finite("a hydrodynamic derivative", name, value, "");
    }

    Form form() {
        Matcher match = NAME.matcher(name);
        if (!match.matches()) {
            throw new IllegalStateException("unchecked derivative " + name);
        }
        int force = FORCES.indexOf(match.group(1));
        int first = VELOCITIES.indexOf(match.group(2));
        if (match.group(3) != null) {
            int second = VELOCITIES.indexOf(match.group(3));
            return new Form(force, Math.min(first, second), Second.SIGNED, Math.max(first, second));
        }
        if (match.group(4) != null) {
            return new Form(force, first, Second.SIZE, VELOCITIES.indexOf(match.group(4)));
        }
        return new Form(force, first, Second.NONE, 0);
    }
}
