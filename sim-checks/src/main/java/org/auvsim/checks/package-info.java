/** What holds for the repository as a whole. */
@NullMarked
package org.auvsim.checks;

import org.jspecify.annotations.NullMarked;
