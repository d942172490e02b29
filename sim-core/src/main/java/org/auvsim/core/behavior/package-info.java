/** Ready-made behaviors: what an object does of its own accord, decided once before each step. */
@NullMarked
package org.auvsim.core.behavior;

import org.jspecify.annotations.NullMarked;
