/** The thesis' experiments (chapter 8). */
@NullMarked
package org.auvsim.experiments;

import org.jspecify.annotations.NullMarked;
