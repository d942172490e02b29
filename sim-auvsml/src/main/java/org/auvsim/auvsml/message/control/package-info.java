/** Commands to the simulator and to world objects. */
@NullMarked
package org.auvsim.auvsml.message.control;

import org.jspecify.annotations.NullMarked;
