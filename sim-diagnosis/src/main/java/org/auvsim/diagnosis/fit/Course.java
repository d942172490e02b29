package org.auvsim.diagnosis.fit;

/**
 * The course of a search: tells how far it is, never less than before, and knows when it was told
 * to stop. For several threads.
 */
public final class Course {
    /** Of what is not worth telling and too short to be stopped. */
    public static final Course UNHEARD = new Course(Progress.SILENT);

    private final Progress progress;
    private String now = "";
    private double furthest;
    private boolean isStopped;

    /** One that is told of. */
    public Course(Progress progress) {
        this.progress = progress;
    }

    /** Tells how far it is, and whether to go on. */
    public synchronized boolean at(String stage, double share) {
        now = stage;
        furthest = Math.max(furthest, share);
        if (!isStopped && !progress.at(stage, furthest)) {
            isStopped = true;
        }
        return !isStopped;
    }

    /**
     * The course of a search that is made in addition: its shares are of the way until that share.
     */
    public synchronized Course more(double until) {
        double from = furthest;
        double way = Math.max(0, until - from);
        return new Course((stage, share) -> at(stage, from + share * way));
    }

    /** Whether to go on with what is being done. */
    public synchronized boolean goesOn() {
        return at(now, furthest);
    }
}
