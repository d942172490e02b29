/** How clients and simulator keep step. */
@NullMarked
package org.auvsim.auvsml.message.lockstep;

import org.jspecify.annotations.NullMarked;
