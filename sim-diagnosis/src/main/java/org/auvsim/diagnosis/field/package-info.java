/** A force that a model lacks, as a map of the places where runs have been. */
@NullMarked
package org.auvsim.diagnosis.field;

import org.jspecify.annotations.NullMarked;
