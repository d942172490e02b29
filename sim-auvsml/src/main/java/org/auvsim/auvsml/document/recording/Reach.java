package org.auvsim.auvsml.document.recording;

/**
 * How far a recording goes.
 *
 * @param isWhole whether it was ended; else it was cut off, as its program was killed or the file
 *     was shortened
 * @param step of the last entry that can be read
 * @param timestamp world time (s) of that entry
 * @param reason why it ends there, in a sentence without a full stop
 */
public record Reach(boolean isWhole, long step, double timestamp, String reason) {}
