package org.auvsim.diagnosis.fit;

/** The course of a search: tells how far it is, and knows when it was told to stop. */
final class Course {
    private final Progress progress;
    private boolean isStopped;

    Course(Progress progress) {
        this.progress = progress;
    }

    /** Tells how far it is, and whether to go on. */
    boolean at(String stage, double share) {
        if (!isStopped && !progress.at(stage, share)) {
            isStopped = true;
        }
        return !isStopped;
    }

    boolean goesOn() {
        return !isStopped;
    }
}
