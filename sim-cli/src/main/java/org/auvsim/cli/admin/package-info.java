/** The administrator's shell: lines in plain words become messages, answers become plain text. */
@NullMarked
package org.auvsim.cli.admin;

import org.jspecify.annotations.NullMarked;
