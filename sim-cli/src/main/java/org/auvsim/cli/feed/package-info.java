/** Measured logs, played to a simulator as position feedback. */
@NullMarked
package org.auvsim.cli.feed;

import org.jspecify.annotations.NullMarked;
