package org.auvsim.cli;

import org.auvsim.auvsml.mapping.Names;

import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Reads the values of options, and says what was expected of one that cannot be read. */
final class OptionValues {
    /** How picocli begins to tell that a value cannot be read, up to what its reader says. */
    private static final String OPENING = "^Invalid value for option '[^']*'[^:]*: ";

    /** How it tells that one stands where a value is expected. */
    private static final Pattern NO_VALUE =
            Pattern.compile("^Unknown option: '([^']*)'; Expected parameter for .*");

    private OptionValues() {}

    /** Lets a command line read numbers by this. */
    static CommandLine readBy(CommandLine line) {
        ITypeConverter<Integer> whole = text -> number(text, Integer::valueOf, "a whole number");
        ITypeConverter<Double> real = text -> number(text, Double::valueOf, "a number");
        ITypeConverter<Long> wide = text -> number(text, Long::valueOf, "a whole number");
        return line.registerConverter(long.class, wide)
                .registerConverter(Long.class, wide)
                .registerConverter(int.class, whole)
                .registerConverter(Integer.class, whole)
                .registerConverter(double.class, real)
                .registerConverter(Double.class, real);
    }

    private static <N> N number(String text, Function<String, N> read, String expected) {
        try {
            return read.apply(text.strip());
        } catch (NumberFormatException _) {
            throw new TypeConversionException(
                    "expected %s, but found '%s'".formatted(expected, text));
        }
    }

    /**
     * The sentence on an option that is not known, or on a value that an option or a choice does
     * not take; empty if neither is the fault.
     */
    static Optional<String> refusal(ParameterException e) {
        Optional<String> unknown = unknown(e);
        if (unknown.isPresent()) {
            return unknown.map(option -> unknown(option, e.getCommandLine().getCommandSpec()));
        }
        ArgSpec argument = e.getArgSpec();
        if (argument != null && String.valueOf(e.getMessage()).startsWith("Value for option ")) {
            return Optional.of(
                    "%s: expected %s, but found '%s'."
                            .formatted(shown(argument), argument.paramLabel(), e.getValue()));
        }
        if (argument == null || !String.valueOf(e.getMessage()).startsWith("Invalid value ")) {
            return Optional.empty();
        }
        boolean isChoice = argument.auxiliaryTypes()[0].isEnum();
        if (!isChoice && argument.isPositional()) {
            return Optional.empty();
        }
        String problem =
                isChoice
                        ? "expected %s, but found '%s'"
                                .formatted(names(argument.auxiliaryTypes()[0]), e.getValue())
                        : String.valueOf(e.getMessage()).replaceFirst(OPENING, "");
        return Optional.of("%s: %s.".formatted(shown(argument), problem));
    }

    /** One that stands where a value is expected, or beside which others are missing. */
    private static Optional<String> unknown(ParameterException e) {
        Matcher noValue = NO_VALUE.matcher(String.valueOf(e.getMessage()));
        if (noValue.matches()) {
            return Optional.of(noValue.group(1));
        }
        List<String> unmatched =
                switch (e) {
                    case MissingParameterException _ -> e.getCommandLine().getUnmatchedArguments();
                    case UnmatchedArgumentException of -> of.getUnmatched();
                    default -> List.of();
                };
        return unmatched.stream().filter(argument -> argument.startsWith("-")).findFirst();
    }

    private static String unknown(String option, CommandSpec of) {
        return Names.meant(Names.near(option, of.optionsMap().keySet()))
                .map(meant -> "Unknown option: '%s'; %s".formatted(option, meant))
                .orElse("Unknown option: '%s'.".formatted(option));
    }

    private static String shown(ArgSpec argument) {
        return argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
    }

    private static String names(Class<?> choices) {
        return Arrays.stream(choices.getEnumConstants())
                .map(choice -> choice.toString().toLowerCase(Locale.ROOT))
                .collect(Collectors.joining(" or "));
    }
}
