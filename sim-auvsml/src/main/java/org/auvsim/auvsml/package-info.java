/**
 * The language that robots, scenarios and recordings are written in; here: what can be wrong with a
 * text.
 */
@NullMarked
package org.auvsim.auvsml;

import org.jspecify.annotations.NullMarked;
