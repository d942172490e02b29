package org.auvsim.auvsml.message.entity;

import java.util.List;
import org.auvsim.auvsml.message.Message;

/** The propulsors of a world object (thesis, appendix A.4). */
public record PropulsorListResponse(long agentId, List<ListedPropulsor> propulsor) implements Message {}
