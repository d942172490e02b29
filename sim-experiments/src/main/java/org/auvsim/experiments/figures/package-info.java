/** The figures of the documentation, drawn from runs of the simulator. */
@NullMarked
package org.auvsim.experiments.figures;

import org.jspecify.annotations.NullMarked;
