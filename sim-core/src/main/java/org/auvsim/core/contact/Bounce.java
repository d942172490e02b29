package org.auvsim.core.contact;

/** How a pair that meets parts again, and by which rule of {@link RestitutionRule}. */
public enum Bounce {
    /** With the restitution of the pair. */
    RESTITUTION,

    /** Elastically, since it follows its last hit at once: the TC rule. */
    ELASTIC_IN_CONTACT_TIME,

    /** Not: it would part slower than the rest speed. The pair may be held. */
    REST_AS_SLOW,

    /** Not: too many hits followed each other at once. The pair may be held. */
    REST_AS_REPEATED;

    /** Whether the pair may be held together as a resting contact. */
    public boolean rests() {
        return this == REST_AS_SLOW || this == REST_AS_REPEATED;
    }

    /**
     * Speed (m/s) at which the pair is to part: the target of its contact.
     *
     * @param approach how fast it meets (m/s), 0 or more
     * @param restitution of the pair, 0 to 1
     */
    public double target(double approach, double restitution) {
        return switch (this) {
            case RESTITUTION -> restitution * approach;
            case ELASTIC_IN_CONTACT_TIME -> approach;
            case REST_AS_SLOW, REST_AS_REPEATED -> 0;
        };
    }
}
