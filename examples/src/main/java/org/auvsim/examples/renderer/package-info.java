/** A renderer of a user's own. */
@NullMarked
package org.auvsim.examples.renderer;

import org.jspecify.annotations.NullMarked;
