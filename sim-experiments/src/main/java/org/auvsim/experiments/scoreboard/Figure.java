package org.auvsim.experiments.scoreboard;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** The figures of a scoreboard, with what is wanted of them at noises of 0.1, 1 and 5 %. */
public enum Figure {
    /** Single effects: the right cause first, and explained. */
    NAMED("named", "99 / 97 / 95 %"),
    /** Pairs: both, and nothing else. */
    PAIRS("pairs, both and nothing else", "98 / 98 / 95 %"),
    /** Nulls that are not told to be none. */
    FALSE_ALARMS("false alarms", "at most 1 %"),
    /** What no cause covers, told to be unexplained. */
    UNEXPLAINED("unexplained, found", "100 / 98 / 95 %"),
    /** Effects of the library that are told to be unexplained. */
    GIVE_UPS("unexplained, said of a library effect", ""),
    /** Effects at 0.3 of their strength that are named. */
    WEAK("named at 0.3 of the strength", "85 % at 1 %"),
    /** Of those that are not, those that are told to be none. */
    WEAK_MISSED("of those missed: none", "all"),
    /** What an alias case can and cannot tell apart, told so: of what is told. */
    ALIAS_PRECISION("aliases, precision", "95 %"),
    /** Of what is to be told. */
    ALIAS_RECALL("aliases, recall", "95 %"),
    /** Median of the parameters' relative errors; for people in per cent, as its target is. */
    PARAMETER_ERROR("parameter error, median", "0.05 / 0.25 / 1.5 %"),
    /** The same, as large as it has to be by the deviations that are stated: what noise leaves. */
    EXPECTED_ERROR("what noise leaves of it, median", ""),
    /** Parameters within their 95 % intervals. */
    COVERAGE("coverage of 95 % intervals", "93-97 %"),
    /** Model error left on held-out runs, as a share. */
    ERROR_LEFT("held-out error left, median (1: no gain)", "0.001 / 0.004 / 0.015"),
    /** Single effects that sparse regression names, and nothing else. */
    BASELINE_NAMED("sparse regression: named", ""),
    /** Pairs that it names, and nothing else. */
    BASELINE_PAIRS("sparse regression: pairs", ""),
    /** Nulls in which it names something. */
    BASELINE_FALSE_ALARMS("sparse regression: false alarms", ""),
    /** Wall time of a diagnosis. */
    SECONDS("seconds a diagnosis, median", "");

    private final String title;
    private final String target;

    Figure(String title, String target) {
        this.title = title;
        this.target = target;
    }

    /** For people. */
    public String title() {
        return title;
    }

    /** What is wanted; empty if nothing is. */
    public String target() {
        return target;
    }

    String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    private Object value(Scores scores) {
        return switch (this) {
            case NAMED -> scores.named();
            case PAIRS -> scores.pairs();
            case FALSE_ALARMS -> scores.falseAlarms();
            case UNEXPLAINED -> scores.unexplained();
            case GIVE_UPS -> scores.giveUps();
            case WEAK -> scores.weak();
            case WEAK_MISSED -> scores.weakMissedAsNone();
            case ALIAS_PRECISION -> scores.aliasPrecision();
            case ALIAS_RECALL -> scores.aliasRecall();
            case PARAMETER_ERROR -> scores.parameterError();
            case EXPECTED_ERROR -> scores.expectedError();
            case COVERAGE -> scores.coverage();
            case ERROR_LEFT -> scores.errorLeft();
            case BASELINE_NAMED -> scores.baselineNamed();
            case BASELINE_PAIRS -> scores.baselinePairs();
            case BASELINE_FALSE_ALARMS -> scores.baselineFalseAlarms();
            case SECONDS -> scores.seconds();
        };
    }

    /** In words and digits. */
    public String of(Scores scores) {
        return switch (value(scores)) {
            case Double d when Double.isNaN(d) -> "-";
            case Double d when this == PARAMETER_ERROR || this == EXPECTED_ERROR ->
                    String.format(Locale.ROOT, "%.3g %%", 100 * d);
            case Double d -> String.format(Locale.ROOT, "%.3g", d);
            case Object share -> share.toString();
        };
    }

    Map<String, Object> forMachines(Scores scores) {
        Map<String, Object> parts = new LinkedHashMap<>();
        switch (value(scores)) {
            case Share share when share.of() > 0 -> {
                parts.put("value", share.value());
                parts.put("low", share.low());
                parts.put("high", share.high());
                parts.put("of", share.of());
            }
            case Double d when !Double.isNaN(d) -> {
                parts.put("value", Optional.of(d).filter(Double::isFinite));
                parts.put("unit", this == SECONDS ? "s" : "1");
            }
            case Object _ -> parts.put("of", 0);
        }
        return parts;
    }
}
