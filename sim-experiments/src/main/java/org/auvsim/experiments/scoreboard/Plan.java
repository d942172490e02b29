package org.auvsim.experiments.scoreboard;

import org.auvsim.experiments.hidden.CaseKind;

import java.util.ArrayList;
import java.util.List;

/**
 * Which cases are drawn.
 *
 * @param seed of the first case; the next ones follow
 * @param cases at each noise
 * @param kinds of them in turn
 * @param noises as shares of the motion's range
 */
public record Plan(long seed, int cases, List<CaseKind> kinds, List<Double> noises) {
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

    /** One case to be drawn. */
    public record Drawing(CaseKind kind, double noise, long seed) {}

    /** The lists cannot be changed. */
    public Plan {
        kinds = List.copyOf(kinds);
        noises = List.copyOf(noises);
    }

    /** All cases; the noises of a case follow one another. */
    public List<Drawing> drawings() {
        List<Drawing> drawings = new ArrayList<>();
        for (int i = 0; i < cases; i++) {
            for (double noise : noises) {
                drawings.add(new Drawing(kinds.get(i % kinds.size()), noise, seed + i));
            }
        }
        return drawings;
    }
}
