/** What the numbers of a vehicle say of it, and which of them look wrong. */
@NullMarked
package org.auvsim.experiments.vehicle;

import org.jspecify.annotations.NullMarked;
