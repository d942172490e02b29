/** What a simulation gets wrong, why, and how much better it can be. */
@NullMarked
package org.auvsim.diagnosis;

import org.jspecify.annotations.NullMarked;
