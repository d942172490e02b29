/** A second simulator beside a server: it runs its own model, compares, and corrects. */
@NullMarked
package org.auvsim.cli.mirror;

import org.jspecify.annotations.NullMarked;
