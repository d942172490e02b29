/** What moved, when, and whether the step is done. */
@NullMarked
package org.auvsim.auvsml.message.movement;

import org.jspecify.annotations.NullMarked;
