/** The {@code auvsim} script: where it finds a JDK, when it builds, what it says. */
@NullMarked
package org.auvsim.checks.launcher;

import org.jspecify.annotations.NullMarked;
