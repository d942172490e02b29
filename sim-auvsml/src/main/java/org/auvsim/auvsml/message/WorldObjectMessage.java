package org.auvsim.auvsml.message;

/** A message about one world object. */
public interface WorldObjectMessage extends Message {
    /** The id of the world object. */
    long worldObjectId();
}
