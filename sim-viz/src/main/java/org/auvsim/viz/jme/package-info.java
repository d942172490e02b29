/** Paints with jMonkeyEngine, by OpenGL. */
@NullMarked
package org.auvsim.viz.jme;

import org.jspecify.annotations.NullMarked;
