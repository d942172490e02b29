/** What a document calls, leaves out, and measures: annotations on record components. */
@NullMarked
package org.auvsim.core.description;

import org.jspecify.annotations.NullMarked;
