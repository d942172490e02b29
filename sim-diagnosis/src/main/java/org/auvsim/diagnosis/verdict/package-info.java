/**
 * Says what measured runs tell of a model. An {@link org.auvsim.diagnosis.verdict.Examination} has
 * the causes searched, judges what was found by held-out runs ({@code Trial}, {@code Judgement}),
 * and puts together all that a diagnosis tells.
 */
@NullMarked
package org.auvsim.diagnosis.verdict;

import org.jspecify.annotations.NullMarked;
