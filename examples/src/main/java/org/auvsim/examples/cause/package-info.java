/** A cause of a user's own that a diagnosis looks for. */
@NullMarked
package org.auvsim.examples.cause;

import org.jspecify.annotations.NullMarked;
