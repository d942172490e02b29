package org.auvsim.checks.offender.server.a;

import org.auvsim.checks.offender.server.b.UsesA;

public record UsesB(UsesA back) {}
