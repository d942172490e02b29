package org.auvsim.core.actuator;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * What a propulsor draws from a battery: its maximum power times the cube of its level, as thrust
 * goes with the square of a propeller's speed and torque, too.
 *
 * @param battery name of the battery in the same object
 * @param maximumPower at level 1 or -1 (W)
 * @param used what it has drawn and the battery has not yet counted (J)
 * @param powered whether the battery has any charge left
 */
public record PowerDraw(
        String battery,
        @Unit("W") double maximumPower,
        @Unit("J") @Default("0.0") double used,
        @Default("1") boolean powered) {
    /**
     * A checked draw.
     *
     * @throws IllegalArgumentException if power or energy is negative or not finite
     */
    public PowerDraw {
        String of = "what is drawn from battery '" + battery + "'";
        Domain.atLeast0(of, "maximum power", maximumPower, "W");
        Domain.atLeast0(of, "used energy", used, "J");
    }

    PowerDraw plus(double energy) {
        return new PowerDraw(battery, maximumPower, used + energy, powered);
    }

    PowerDraw counted(boolean stillPowered) {
        return new PowerDraw(battery, maximumPower, 0, stillPowered);
    }
}
