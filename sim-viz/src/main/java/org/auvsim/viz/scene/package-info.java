/** What there is to see: the objects, where they are, and what happened to them. */
@NullMarked
package org.auvsim.viz.scene;

import org.jspecify.annotations.NullMarked;
