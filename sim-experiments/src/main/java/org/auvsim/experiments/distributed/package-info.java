/** The thesis' section 8.3 again: a simulation in one process and the same one distributed. */
@NullMarked
package org.auvsim.experiments.distributed;

import org.jspecify.annotations.NullMarked;
