package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.entity.Field;

import java.util.List;

/** The fields of the world, as a scenario would state them, in order of id. */
public record FieldListResponse(List<Field<?>> field) implements Message {}
