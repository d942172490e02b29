/** An effect of a user's own, in its easy form. */
@NullMarked
package org.auvsim.examples.effect;

import org.jspecify.annotations.NullMarked;
