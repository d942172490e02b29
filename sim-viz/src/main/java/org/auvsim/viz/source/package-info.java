/** Where a scene comes from: a running simulator or a recording. */
@NullMarked
package org.auvsim.viz.source;

import org.jspecify.annotations.NullMarked;
