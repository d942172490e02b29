/** Diagnosis while a simulation runs: learns from corrective feedback what the model lacks. */
@NullMarked
package org.auvsim.diagnosis.online;

import org.jspecify.annotations.NullMarked;
