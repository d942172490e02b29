/** What a diagnosis comes to. */
@NullMarked
package org.auvsim.diagnosis.result;

import org.jspecify.annotations.NullMarked;
