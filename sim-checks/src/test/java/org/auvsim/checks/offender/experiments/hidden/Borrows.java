package org.auvsim.checks.offender.experiments.hidden;

import org.auvsim.checks.offender.core.volume.UsesServer;

record Borrows(UsesServer physics) {}
