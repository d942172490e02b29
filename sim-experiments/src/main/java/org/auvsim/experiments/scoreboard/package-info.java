/** How well diagnoses do on cases whose hidden causes are known. */
@NullMarked
package org.auvsim.experiments.scoreboard;

import org.jspecify.annotations.NullMarked;
