package org.auvsim.experiments.scoreboard;

/**
 * Whether two causes cannot be told apart.
 *
 * @param so in truth, by the data
 * @param told by the diagnosis
 */
public record AliasTold(boolean so, boolean told) {
    /** There is nothing to be told. */
    public static final AliasTold NONE = new AliasTold(false, false);
}
