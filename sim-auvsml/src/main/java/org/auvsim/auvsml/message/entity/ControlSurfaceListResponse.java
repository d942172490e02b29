package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;

import java.util.List;

/** The fins of a world object that can be turned. */
public record ControlSurfaceListResponse(long agentId, List<ListedControlSurface> controlSurface)
        implements Message {}
