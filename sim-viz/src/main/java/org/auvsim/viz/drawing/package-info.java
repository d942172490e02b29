/** How a scene becomes shapes, lines and words, whoever paints them. */
@NullMarked
package org.auvsim.viz.drawing;

import org.jspecify.annotations.NullMarked;
