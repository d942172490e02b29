/**
 * How bodies move and bounce: equations of motion, their integration, the impulse of a collision.
 */
@NullMarked
package org.auvsim.core.dynamics;

import org.jspecify.annotations.NullMarked;
