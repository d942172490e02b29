/** The window around the picture: lists, sliders, time line. */
@NullMarked
package org.auvsim.viz.window;

import org.jspecify.annotations.NullMarked;
