/** Ready-made effects: forces and torques that act on rigid bodies while they move. */
@NullMarked
package org.auvsim.core.effect;

import org.jspecify.annotations.NullMarked;
