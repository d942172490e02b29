/** The simulated world. */
@NullMarked
package org.auvsim.core;

import org.jspecify.annotations.NullMarked;
