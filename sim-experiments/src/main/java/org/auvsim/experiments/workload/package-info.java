/** The worlds that the experiments run. */
@NullMarked
package org.auvsim.experiments.workload;

import org.jspecify.annotations.NullMarked;
