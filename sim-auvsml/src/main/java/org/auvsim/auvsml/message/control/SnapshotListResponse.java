package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.KeptSnapshot;

import java.util.List;

/** The snapshots that the simulator keeps, in the order in which they were first taken. */
public record SnapshotListResponse(List<KeptSnapshot> snapshot) implements Message {}
