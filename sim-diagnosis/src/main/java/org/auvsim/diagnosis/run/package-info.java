/** Measured runs. */
@NullMarked
package org.auvsim.diagnosis.run;

import org.jspecify.annotations.NullMarked;
