/** A message of a user's own: the thesis' example, Listing 7.2. */
@NullMarked
package org.auvsim.examples.messages;

import org.jspecify.annotations.NullMarked;
