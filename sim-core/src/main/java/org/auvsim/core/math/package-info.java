/** Immutable vectors, quaternions and matrices, right-handed, in SI units. */
@NullMarked
package org.auvsim.core.math;

import org.jspecify.annotations.NullMarked;
