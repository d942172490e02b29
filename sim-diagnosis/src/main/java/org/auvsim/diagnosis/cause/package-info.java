/** What a model may lack or have wrong. */
@NullMarked
package org.auvsim.diagnosis.cause;

import org.jspecify.annotations.NullMarked;
