/** Threads for the parts of a step, which sim-core itself does not start. */
@NullMarked
package org.auvsim.server.lanes;

import org.jspecify.annotations.NullMarked;
