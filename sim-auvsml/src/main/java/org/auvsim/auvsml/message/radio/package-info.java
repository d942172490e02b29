/** Messages of world objects to one another, by modem and by radio. */
@NullMarked
package org.auvsim.auvsml.message.radio;

import org.jspecify.annotations.NullMarked;
