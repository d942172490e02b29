/** From where a scene is looked at. */
@NullMarked
package org.auvsim.viz.camera;

import org.jspecify.annotations.NullMarked;
