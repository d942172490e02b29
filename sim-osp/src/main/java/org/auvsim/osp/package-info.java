// SPDX-License-Identifier: GPL-2.0-or-later
/**
 * The solvers of Open Source Physics (W. Christian, F. Esquembre and others) as integrators of
 * worlds.
 */
@NullMarked
package org.auvsim.osp;

import org.jspecify.annotations.NullMarked;
