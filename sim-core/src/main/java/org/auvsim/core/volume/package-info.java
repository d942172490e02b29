/** The shapes of things, and whether and where two of them touch. */
@NullMarked
package org.auvsim.core.volume;

import org.jspecify.annotations.NullMarked;
