package org.auvsim.diagnosis.fit;

/**
 * The course of a search: tells how far it is, never less than before, and knows when it was told
 * to stop. For several threads.
 */
final class Course {
    private final Progress progress;
    private double furthest;
    private boolean isStopped;

    Course(Progress progress) {
        this.progress = progress;
    }

    /** Tells how far it is, and whether to go on. */
    synchronized boolean at(String stage, double share) {
        furthest = Math.max(furthest, share);
        if (!isStopped && !progress.at(stage, furthest)) {
            isStopped = true;
        }
        return !isStopped;
    }

    synchronized boolean goesOn() {
        return !isStopped;
    }
}
