/** The thesis' section 8.1 again: corrective feedback with and without lag. */
@NullMarked
package org.auvsim.experiments.cfs;

import org.jspecify.annotations.NullMarked;
