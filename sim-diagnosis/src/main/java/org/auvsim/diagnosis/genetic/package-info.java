/** Evolution of models: populations of them compete side by side (thesis, section 9.4). */
@NullMarked
package org.auvsim.diagnosis.genetic;

import org.jspecify.annotations.NullMarked;
