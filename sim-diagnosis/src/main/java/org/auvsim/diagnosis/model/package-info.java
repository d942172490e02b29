/** The model as it is believed, its variants, and how they move. */
@NullMarked
package org.auvsim.diagnosis.model;

import org.jspecify.annotations.NullMarked;
