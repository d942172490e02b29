package org.auvsim.auvsml.message;

/**
 * A message that client or server sends: a record, whose AUVSML form follows from its name and
 * components (thesis, section 7.1).
 *
 * <p>A message of a user's own is one such record, named in a provider file {@code
 * META-INF/services/org.auvsim.auvsml.message.Message}.
 */
public interface Message {}
