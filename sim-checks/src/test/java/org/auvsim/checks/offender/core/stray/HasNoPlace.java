package org.auvsim.checks.offender.core.stray;

public record HasNoPlace() {}
