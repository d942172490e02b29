/** Entities that come, go, and are asked about. */
@NullMarked
package org.auvsim.auvsml.message.entity;

import org.jspecify.annotations.NullMarked;
