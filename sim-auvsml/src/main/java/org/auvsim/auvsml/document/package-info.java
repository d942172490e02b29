/** AUVSML in files: scenarios, and whether a file is right. */
@NullMarked
package org.auvsim.auvsml.document;

import org.jspecify.annotations.NullMarked;
