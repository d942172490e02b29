/** A field of a user's own. */
@NullMarked
package org.auvsim.examples.field;

import org.jspecify.annotations.NullMarked;
