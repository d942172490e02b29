package org.auvsim.checks.offender.core.math;

import org.auvsim.checks.offender.core.volume.UsesServer;

public record UsesVolume(UsesServer volume) {}
