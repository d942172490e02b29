/** A stage of the step of a user's own. */
@NullMarked
package org.auvsim.examples.stage;

import org.jspecify.annotations.NullMarked;
