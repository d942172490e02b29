package org.auvsim.diagnosis.reading;

/** A place in a row as people say it: {@code third}, {@code 21st}. */
final class Ordinal {
    private Ordinal() {}

    static String of(long number) {
        return number == 2 ? "second" : number == 3 ? "third" : number + ending(number);
    }

    private static String ending(long number) {
        boolean isTeen = number / 10 % 10 == 1;
        return switch (isTeen ? 0 : (int) (number % 10)) {
            case 1 -> "st";
            case 2 -> "nd";
            case 3 -> "rd";
            default -> "th";
        };
    }
}
