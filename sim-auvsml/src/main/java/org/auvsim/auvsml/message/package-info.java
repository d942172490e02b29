/** What client and server say to each other: each message is one record. */
@NullMarked
package org.auvsim.auvsml.message;

import org.jspecify.annotations.NullMarked;
