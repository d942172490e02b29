package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.entity.Effect;

import java.util.List;

/** The effects on a world object, as a scenario would state them, in the order of their coming. */
public record EffectListResponse(long worldObjectId, List<Effect> effect) implements Message {}
