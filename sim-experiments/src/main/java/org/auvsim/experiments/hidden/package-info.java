/**
 * Measured runs with a cause hidden in them, for judging a diagnosis: equations of motion of its
 * own, none of the simulator's.
 */
@NullMarked
package org.auvsim.experiments.hidden;

import org.jspecify.annotations.NullMarked;
