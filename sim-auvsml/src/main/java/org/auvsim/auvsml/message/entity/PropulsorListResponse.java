package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;

import java.util.List;

/** The propulsors of a world object (thesis, appendix A.4). */
public record PropulsorListResponse(long agentId, List<ListedPropulsor> propulsor)
        implements Message {}
