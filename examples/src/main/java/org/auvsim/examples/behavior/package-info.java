/** A behavior of a user's own. */
@NullMarked
package org.auvsim.examples.behavior;

import org.jspecify.annotations.NullMarked;
