/**
 * Finds the causes that fit: windows that follow the measurement, their derivatives, and the
 * search.
 */
@NullMarked
package org.auvsim.diagnosis.fit;

import org.jspecify.annotations.NullMarked;
