/** How commands that fail tell why. */
@NullMarked
package org.auvsim.cli.report;

import org.jspecify.annotations.NullMarked;
