/** What the tracked files must not contain, and what their links must lead to. */
@NullMarked
package org.auvsim.checks.repository;

import org.jspecify.annotations.NullMarked;
