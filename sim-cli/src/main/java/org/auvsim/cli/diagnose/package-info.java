/** How a diagnosis is told at the command line. */
@NullMarked
package org.auvsim.cli.diagnose;

import org.jspecify.annotations.NullMarked;
