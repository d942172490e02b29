/** Pictures of runs. */
@NullMarked
package org.auvsim.plot;

import org.jspecify.annotations.NullMarked;
