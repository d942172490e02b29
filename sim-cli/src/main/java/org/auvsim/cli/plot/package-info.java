/** Pictures of runs. */
@NullMarked
package org.auvsim.cli.plot;

import org.jspecify.annotations.NullMarked;
