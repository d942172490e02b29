package org.auvsim.checks.launcher;

/** How a launcher ended, and what it said. */
record Run(int code, String out, String err) {}
