/**
 * What recordings consist of: what went into a simulation and what came of it, so that it can be
 * run again bit for bit. docs/recording.md has the format.
 */
@NullMarked
package org.auvsim.auvsml.recording;

import org.jspecify.annotations.NullMarked;
