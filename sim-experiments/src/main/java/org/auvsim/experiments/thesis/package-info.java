/** The thesis' section 8.2: what its stages cost, and how that grows with the number of bodies. */
@NullMarked
package org.auvsim.experiments.thesis;

import org.jspecify.annotations.NullMarked;
