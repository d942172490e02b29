package org.auvsim.viz.source;

import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SceneClock;

import java.util.List;

/** Writes into a scene what a chronicle tells of a time. Belongs to one thread at a time. */
final class ShownChronicle {
    /** So many collisions and occurrences are told at once. */
    private static final int MOST_AT_ONCE = 200;

    private final Chronicle chronicle;
    private final Clock clock = new Clock();
    private final Scene scene = new Scene(clock);
    private final List<ShownCourse> courses;
    private double shown = Double.NEGATIVE_INFINITY;
    private int fields;
    private int meetings;
    private int occurrences;

    ShownChronicle(Chronicle chronicle) {
        this.chronicle = chronicle;
        this.courses =
                chronicle.courses().stream().map(course -> new ShownCourse(course, scene)).toList();
    }

    Scene scene() {
        return scene;
    }

    /** Shows a time (s). */
    void show(double time) {
        boolean back = time < shown;
        shown = time;
        clock.time = time;
        if (back) {
            rewind(time);
        }
        for (int i = 0; i < courses.size(); i++) {
            courses.get(i).leave(time);
        }
        for (int i = 0; i < courses.size(); i++) {
            courses.get(i).show(time, back);
        }
        showFields(time);
        showMeetings(time);
        showOccurrences(time);
    }

    /** What was told of the time after is not told any more. */
    private void rewind(double time) {
        scene.jumpTo(time);
        meetings = 0;
        occurrences = chronicle.occurrences().countUntil(time);
        for (Occurrence unread : scene.drainOccurrences()) {
            if (unread.time() <= time) {
                scene.tell(unread);
            }
        }
    }

    private void showFields(double time) {
        int count = chronicle.fields().countUntil(time);
        if (count != fields) {
            fields = count;
            scene.setFields(count == 0 ? List.of() : chronicle.fields().get(count - 1));
        }
    }

    private void showMeetings(double time) {
        int count = chronicle.meetings().countUntil(time);
        for (int i = Math.max(meetings, count - MOST_AT_ONCE); i < count; i++) {
            scene.meet(chronicle.meetings().get(i));
        }
        meetings = count;
    }

    private void showOccurrences(double time) {
        int count = chronicle.occurrences().countUntil(time);
        for (int i = Math.max(occurrences, count - MOST_AT_ONCE); i < count; i++) {
            scene.tell(chronicle.occurrences().get(i));
        }
        occurrences = count;
    }

    /** Tells the time that is shown, whatever the machine's clock says. */
    private static final class Clock implements SceneClock {
        private volatile double time;

        @Override
        public void stepDone(double end, long nanos) {
            // the play head alone decides
        }

        @Override
        public void jump(double to) {
            time = to;
        }

        @Override
        public double at(long nanos) {
            return time;
        }
    }
}
