/** How fast the parts are, measured with JMH. */
@NullMarked
package org.auvsim.bench;

import org.jspecify.annotations.NullMarked;
