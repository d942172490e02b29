package org.auvsim.auvsml.document;

/** What a simulation in lock-step does when members have not answered in time. */
public enum WhenLate {
    /** It goes on waiting. */
    WAIT("wait"),
    /** It makes this step without them. */
    GO_ON("go-on"),
    /** They are members no longer, and control nothing any more. */
    RELEASE("release");

    private final String text;

    WhenLate(String text) {
        this.text = text;
    }

    /** As AUVSML has it. */
    @Override
    public String toString() {
        return text;
    }
}
