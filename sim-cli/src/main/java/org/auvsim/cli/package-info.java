/** The {@code auvsim} command. */
@NullMarked
package org.auvsim.cli;

import org.jspecify.annotations.NullMarked;
