package org.auvsim.auvsml.message.command;

import java.util.List;

/** What a {@link ClientCommand} can do: one client's session. */
public interface SessionControl {
    /**
     * Sends this client the named events of the named objects from now on; all registrations or
     * none.
     *
     * @throws RefusedException if an id or an event type is unknown
     */
    void register(List<ListenedObject> objects);

    /**
     * Ends registrations: {@code *ALL*} ends all of that object, a type only that type.
     *
     * @throws RefusedException if an id or an event type is unknown
     */
    void unregister(List<ListenedObject> objects);

    /**
     * Makes this client the one that controls a world object.
     *
     * @throws RefusedException if there is no such object or another client controls it
     */
    void takeControl(long worldObjectId);

    /**
     * Lets go of a world object.
     *
     * @throws RefusedException if this client does not control it
     */
    void releaseControl(long worldObjectId);

    /**
     * Gives this client a name and, in lock-step, makes it a member.
     *
     * @return the number of the step that it has to answer first
     * @throws RefusedException if another client has the name, or this one has another
     */
    long join(String name);

    /**
     * Takes the answer of this member to a step.
     *
     * @throws RefusedException if it is no member, or has to answer another step
     */
    void ready(long step);

    /** Ends the session when all that is on its way to the client is sent. */
    void disconnect();
}
