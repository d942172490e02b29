/** The connection itself: greeting, errors, the end. */
@NullMarked
package org.auvsim.auvsml.message.session;

import org.jspecify.annotations.NullMarked;
