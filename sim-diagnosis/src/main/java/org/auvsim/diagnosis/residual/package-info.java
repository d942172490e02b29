/**
 * What a motion misses of measured runs, in standard deviations of the noise. {@code Noise} is told
 * from the runs themselves, {@code Misses} weighs what a motion misses of one of them, and {@code
 * Whiteness} says whether nothing but noise is left.
 */
@NullMarked
package org.auvsim.diagnosis.residual;

import org.jspecify.annotations.NullMarked;
