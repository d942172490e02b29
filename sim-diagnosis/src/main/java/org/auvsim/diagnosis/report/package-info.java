/** A diagnosis as files, for people and for machines. */
@NullMarked
package org.auvsim.diagnosis.report;

import org.jspecify.annotations.NullMarked;
