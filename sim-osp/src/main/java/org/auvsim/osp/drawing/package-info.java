// SPDX-License-Identifier: GPL-2.0-or-later
/** Paints scenes with the three dimensions of Open Source Physics, which need no OpenGL. */
@NullMarked
package org.auvsim.osp.drawing;

import org.jspecify.annotations.NullMarked;
