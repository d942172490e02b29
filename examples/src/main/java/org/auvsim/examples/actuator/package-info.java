/** An actuator of a user's own. */
@NullMarked
package org.auvsim.examples.actuator;

import org.jspecify.annotations.NullMarked;
