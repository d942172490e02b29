/**
 * What a document may leave out and what its numbers are measured in: annotations on record
 * components.
 */
@NullMarked
package org.auvsim.core.description;

import org.jspecify.annotations.NullMarked;
