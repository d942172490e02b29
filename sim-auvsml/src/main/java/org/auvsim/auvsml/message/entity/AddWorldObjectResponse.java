package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;

/** The id of the world object that was added. */
public record AddWorldObjectResponse(long worldObjectId) implements Message {}
