package org.auvsim.auvsml.document.recording;

/**
 * A root element of a recording, as it stands there.
 *
 * @param number of the root, from 1
 * @param line at which it begins, from 1
 * @param isLast whether nothing follows
 */
@SuppressWarnings("ArrayRecordComponent") // used within this package, never compared
record RootText(byte[] bytes, long number, int line, boolean isLast) {}
