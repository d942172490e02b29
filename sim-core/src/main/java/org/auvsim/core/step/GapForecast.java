package org.auvsim.core.step;

import org.auvsim.core.volume.Manifold;
import org.auvsim.core.volume.Pose;

/**
 * Gaps and speeds of an island's contacts where a segment starts and where a trial ends. The
 * contacts lie where the trial has the bodies halfway; the bodies' ways from there lead to both
 * ends. Other constant forces over the time h that make a contact part faster at the end by dv make
 * its end gap wider by dv h / 2.
 */
final class GapForecast {
    /** The share of the margin by which gaps may open without being noticed. */
    private static final double SLACK = 0.02;

    /** A pair bends slightly if it does so by less than this part of the margin. */
    private static final double SLIGHT_PART = 100;

    private final Paths paths;
    private final Touch touch;
    private final ContactProblem problem;
    private final IslandTrial trial;
    private final IslandContacts contacts;
    private final Manifold manifold = new Manifold();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** The least gap (m) of each pair as it was found where the segment starts. */
    private double[] leastAtStart = new double[64];

    /** What each pair's speeds of approach change by from halfway to the end (m/s), roughly. */
    private double[] bend = new double[64];

    /** The gap (m) of each contact, and how fast it parts (m/s), at the start and at the end. */
    private double[] startGap = new double[64];

    private double[] startSpeed = new double[64];
    private double[] endGap = new double[64];
    private double[] endSpeed = new double[64];

    GapForecast(
            Paths paths,
            Touch touch,
            ContactProblem problem,
            IslandTrial trial,
            IslandContacts contacts) {
        this.paths = paths;
        this.touch = touch;
        this.problem = problem;
        this.trial = trial;
        this.contacts = contacts;
    }

    /** Notes the gaps of the contacts that have been found where the segment starts. */
    void noteStart() {
        reserve();
        for (int c = 0; c < contacts.count(); c++) {
            startGap[c] = problem.gap(c);
        }
        for (int k = 0; k < contacts.pairs(); k++) {
            leastAtStart[k] = contacts.least(k, startGap);
        }
    }

    private void reserve() {
        if (bend.length < contacts.pairs()) {
            leastAtStart = new double[2 * contacts.pairs()];
            bend = new double[2 * contacts.pairs()];
        }
        if (startGap.length < contacts.count()) {
            startGap = new double[2 * contacts.count()];
            startSpeed = new double[2 * contacts.count()];
            endGap = new double[2 * contacts.count()];
            endSpeed = new double[2 * contacts.count()];
        }
    }

    /** Foretells gaps and speeds from the contacts halfway, for a trial over {@code h} (s). */
    void foretell(double h) {
        reserve();
        trial.useWayToMiddle();
        for (int c = 0; c < contacts.count(); c++) {
            startGap[c] = problem.gap(c) - contacts.speed(c);
        }
        trial.useWayToEnd();
        for (int c = 0; c < contacts.count(); c++) {
            endGap[c] = problem.gap(c) + contacts.speed(c);
        }
        trial.useStartVelocity();
        noteSpeeds(startSpeed);
        trial.useEndVelocity();
        noteSpeeds(endSpeed);
        for (int k = 0; k < contacts.pairs(); k++) {
            bend[k] = h / 2 * contacts.bend(k);
            if (bend[k] * h > contacts.margin(k) / SLIGHT_PART) {
                correctEnd(k);
            }
        }
    }

    private void noteSpeeds(double[] to) {
        for (int c = 0; c < contacts.count(); c++) {
            to[c] = contacts.speed(c);
        }
    }

    /** Looks up how far apart a pair is at the trial's end, and shifts its end gaps to that. */
    private void correctEnd(int k) {
        int a = contacts.first(k);
        int b = contacts.second(k);
        paths.endPose(a, poseA);
        paths.endPose(b, poseB);
        touch.find(a, poseA, b, poseB, contacts.reach(k), manifold);
        if (manifold.count > 0) {
            double shift = manifold.leastGap() - contacts.least(k, endGap);
            for (int c = contacts.from(k); c < contacts.to(k); c++) {
                endGap[c] += shift;
            }
        }
    }

    /** By how much (m/s) a pair's speeds of approach change from halfway to the end, roughly. */
    double bend(int pair) {
        return bend[pair];
    }

    /** The gap (m) of a contact where the segment starts. */
    double atStart(int contact) {
        return startGap[contact];
    }

    /** The gap (m) of a contact where the trial ends. */
    double atEnd(int contact) {
        return endGap[contact];
    }

    /** How fast (m/s) a contact parts where the segment starts. */
    double speedAtStart(int contact) {
        return startSpeed[contact];
    }

    /** How fast (m/s) a contact parts where the trial ends. */
    double speedAtEnd(int contact) {
        return endSpeed[contact];
    }

    /** Makes the end gaps those of the forces that have been solved for, over {@code h} (s). */
    private void takeSolution(double h) {
        for (int c = 0; c < contacts.count(); c++) {
            double speed = contacts.speed(c);
            endGap[c] += h / 2 * (speed - endSpeed[c]);
            endSpeed[c] = speed;
        }
    }

    /**
     * The work (J) that it takes to open the gaps as far as the forces open them that have been
     * solved for, over {@code h} (s).
     */
    double workOfOpening(double h) {
        takeSolution(h);
        double work = 0;
        for (int k = 0; k < contacts.pairs(); k++) {
            double margin = contacts.margin(k);
            boolean isStraight = contacts.bend(k) * h * h < SLACK * margin;
            double together = contacts.least(k, endGap) - leastAtStart[k];
            for (int c = contacts.from(k); c < contacts.to(k); c++) {
                double opened = isStraight ? endGap[c] - startGap[c] : together;
                double pressing = problem.contacts.jn[c] / h;
                work += pressing * Math.clamp(opened, SLACK * margin, margin);
            }
        }
        return work;
    }
}
