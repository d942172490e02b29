/** What may depend on what, and on what nothing may depend. */
@NullMarked
package org.auvsim.checks.architecture;

import org.jspecify.annotations.NullMarked;
