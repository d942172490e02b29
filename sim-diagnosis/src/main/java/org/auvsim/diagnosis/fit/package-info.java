/**
 * Fits what a model lacks to measured runs. A {@code Hypothesis}, some causes and their numbers,
 * makes a {@code Fit}; {@code Following} finds where runs begin, {@code Refinement} comes near in
 * windows, {@code Descent} goes down to the end, {@code Uncertainty} says how sure the numbers are.
 */
@NullMarked
package org.auvsim.diagnosis.fit;

import org.jspecify.annotations.NullMarked;
