package org.auvsim.checks.offender.core.volume;

import org.auvsim.checks.offender.server.a.UsesB;

public record UsesServer(UsesB server) {}
