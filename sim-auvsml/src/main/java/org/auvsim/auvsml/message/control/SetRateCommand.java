package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Sets how fast the world's time goes.
 *
 * @param rate world seconds a second, above 0, or {@code max}: as fast as possible
 */
public record SetRateCommand(String rate) implements SimulatorCommand {
    private static final String MAX = "max";

    /**
     * A checked command.
     *
     * @throws IllegalArgumentException if the rate is neither a number above 0 nor {@code max}
     */
    public SetRateCommand {
        if (!rate.equals(MAX) && !isPositiveNumber(rate)) {
            throw new IllegalArgumentException(
                    "rate must be a number above 0, or 'max', but is '" + rate + "'");
        }
    }

    private static boolean isPositiveNumber(String rate) {
        return rate.matches("[0-9]{1,9}(\\.[0-9]{1,9})?") && Double.parseDouble(rate) > 0;
    }

    /** World seconds a second; empty: as fast as possible. */
    public OptionalDouble factor() {
        return rate.equals(MAX)
                ? OptionalDouble.empty()
                : OptionalDouble.of(Double.parseDouble(rate));
    }

    /** A rate as this command and the simulator's state write it. */
    static String text(OptionalDouble factor) {
        return factor.isPresent() ? Double.toString(factor.getAsDouble()) : MAX;
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.setRate(factor());
        return Optional.empty();
    }
}
