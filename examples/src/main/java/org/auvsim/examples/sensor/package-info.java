/** A sensor of a user's own. */
@NullMarked
package org.auvsim.examples.sensor;

import org.jspecify.annotations.NullMarked;
