/** The language that robots, scenarios and recordings are written in. */
@NullMarked
package org.auvsim.auvsml;

import org.jspecify.annotations.NullMarked;
