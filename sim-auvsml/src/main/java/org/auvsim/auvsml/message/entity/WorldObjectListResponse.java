package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedWorldObject;

import java.util.List;

/** All world objects, in order of id; other entities are not in the list (thesis, appendix A.4). */
public record WorldObjectListResponse(List<ListedWorldObject> worldObject) implements Message {}
