/** The thesis' section 8.2 again: what the stages cost, and real time against world time. */
@NullMarked
package org.auvsim.experiments.runtime;

import org.jspecify.annotations.NullMarked;
