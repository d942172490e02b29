/**
 * Ready-made fields: quantities that have a value anywhere in the world, such as a water current.
 */
@NullMarked
package org.auvsim.core.field;

import org.jspecify.annotations.NullMarked;
