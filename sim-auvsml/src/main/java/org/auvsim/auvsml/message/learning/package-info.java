/** What was found that the model of a world object lacks. */
@NullMarked
package org.auvsim.auvsml.message.learning;

import org.jspecify.annotations.NullMarked;
