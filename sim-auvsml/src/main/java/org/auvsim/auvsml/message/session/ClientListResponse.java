package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedClient;

import java.util.List;

/** The clients that are connected, in the order in which they came. */
public record ClientListResponse(List<ListedClient> client) implements Message {}
