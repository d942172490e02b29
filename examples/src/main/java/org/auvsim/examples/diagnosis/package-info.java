/** Diagnoses from Java. */
@NullMarked
package org.auvsim.examples.diagnosis;

import org.jspecify.annotations.NullMarked;
