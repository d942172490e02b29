/** Recordings as tables, for whatever reads CSV or SQL. */
@NullMarked
package org.auvsim.cli.export;

import org.jspecify.annotations.NullMarked;
