package org.auvsim.core.contact;

/**
 * When a pair bounces and when it comes to rest. With restitution below 1 a pair hits ever faster
 * and ever softer, infinitely often in a finite time; what really touches for a while is then no
 * event any more. Luding &amp; McNamara (How to handle the inelastic collapse of a dissipative
 * hard-sphere gas with the TC model, Granular Matter 1, 1998): a hit within the contact time of the
 * pair's last one takes no energy. Here only one ({@link #INELASTIC}) does so; at the next as soon
 * the pair rests.
 *
 * <p>A pair of restitution 1 would bounce for ever, and is to: an elastic gas must not be braked.
 * The event stepper asks {@link #ELASTIC} for its rest speed only, which is so small that it ends
 * nothing but rounding; it does not count the repeats of such a pair.
 *
 * @param restSpeed a pair that would part slower than this (m/s) rests
 * @param contactTime hits of a pair nearer together than this (s) are one long touch
 * @param mostRepeats so many such hits in a row are let bounce
 */
public record RestitutionRule(double restSpeed, double contactTime, int mostRepeats) {
    /**
     * For restitution below 1. At 5 cm/s a hop under gravity rises 0.13 mm and lasts 10 ms, which
     * is the contact time of soft balls of some decimetres and a fifth of a time step of 50 ms.
     */
    public static final RestitutionRule INELASTIC = new RestitutionRule(5e-2, 1e-2, 1);

    /**
     * For restitution 1. Parting at 1 micrometre a second is rounding rather than motion. Whoever
     * counts repeats: a hundred hits in a row within 0.1 ms of each other carry at most 0.5 mm/s
     * under gravity.
     */
    public static final RestitutionRule ELASTIC = new RestitutionRule(1e-6, 1e-4, 100);

    /** Checks the numbers. */
    public RestitutionRule {
        if (!(restSpeed >= 0) || !(contactTime >= 0) || mostRepeats < 0) {
            throw new IllegalArgumentException(
                    "A restitution rule needs a rest speed, a contact time and a number of repeats"
                            + " of 0 or more, not "
                            + restSpeed
                            + ", "
                            + contactTime
                            + " and "
                            + mostRepeats
                            + ".");
        }
    }

    /** The rule for pairs of this restitution. */
    public static RestitutionRule of(double restitution) {
        return restitution < 1 ? INELASTIC : ELASTIC;
    }

    /**
     * How a pair that meets parts again.
     *
     * @param approach how fast it meets (m/s), 0 or more
     * @param restitution of the pair, 0 to 1
     * @param repeats what {@link #repeats} gave for this hit
     */
    public Bounce decide(double approach, double restitution, int repeats) {
        if (restitution * approach < restSpeed) {
            return Bounce.REST_AS_SLOW;
        }
        if (repeats > mostRepeats) {
            return Bounce.REST_AS_REPEATED;
        }
        return repeats > 0 ? Bounce.ELASTIC_IN_CONTACT_TIME : Bounce.RESTITUTION;
    }

    /**
     * How many hits in a row, this one counted, followed the pair's hit before within the contact
     * time.
     *
     * @param sinceLast time since the pair's last hit (s); infinite if there was none
     * @param before what this gave for the last hit; 0 if there was none
     */
    public int repeats(double sinceLast, int before) {
        return sinceLast < contactTime ? before + 1 : 0;
    }
}
