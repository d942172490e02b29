package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.Method;
import org.auvsim.experiments.hidden.CaseKind;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Which cases are drawn.
 *
 * @param seed of the first case; the next ones follow
 * @param cases at each noise
 * @param kinds of them in turn
 * @param noises as shares of the motion's range
 * @param genetic so many of the cases at each noise, the first ones, are also searched by {@link
 *     Method#GENETIC}
 */
public record Plan(long seed, int cases, List<CaseKind> kinds, List<Double> noises, int genetic) {
    /** Twenty cases: how often each kind comes. */
    public static final List<CaseKind> MIXED =
            List.of(
                    CaseKind.SINGLE,
                    CaseKind.NULL,
                    CaseKind.PAIR,
                    CaseKind.SINGLE,
                    CaseKind.UNCOVERED,
                    CaseKind.SINGLE,
                    CaseKind.NULL,
                    CaseKind.PAIR,
                    CaseKind.SINGLE,
                    CaseKind.WEAK,
                    CaseKind.SINGLE,
                    CaseKind.NULL,
                    CaseKind.ALIAS,
                    CaseKind.SINGLE,
                    CaseKind.UNCOVERED,
                    CaseKind.SINGLE,
                    CaseKind.PAIR,
                    CaseKind.NULL,
                    CaseKind.SINGLE,
                    CaseKind.WEAK);

    /** Those of the targets. */
    public static final List<Double> NOISES = List.of(0.001, 0.01, 0.05);

    /** One case to be drawn, and how its causes are searched for. */
    public record Drawing(CaseKind kind, double noise, long seed, Method method) {}

    /** The lists cannot be changed. */
    public Plan {
        kinds = List.copyOf(kinds);
        noises = List.copyOf(noises);
    }

    /** Those that are compared. */
    List<Method> methods() {
        return genetic == 0 ? List.of(Method.SHOOTING) : List.of(Method.values());
    }

    /**
     * That not all cases were judged, in a sentence; empty if they were.
     *
     * @param judged so many outcomes there are
     */
    public Optional<String> shortfall(int judged) {
        int all = drawings().size();
        return judged == all
                ? Optional.empty()
                : Optional.of("Incomplete: %d of %d diagnoses were judged.".formatted(judged, all));
    }

    /** All cases; the noises of a case follow one another. */
    public List<Drawing> drawings() {
        List<Drawing> drawings = new ArrayList<>();
        for (int i = 0; i < cases; i++) {
            for (double noise : noises) {
                CaseKind kind = kinds.get(i % kinds.size());
                for (Method method : methods()) {
                    if (method == Method.SHOOTING || i < genetic) {
                        drawings.add(new Drawing(kind, noise, seed + i, method));
                    }
                }
            }
        }
        return drawings;
    }
}
