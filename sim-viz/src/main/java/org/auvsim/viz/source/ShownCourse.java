package org.auvsim.viz.source;

import org.auvsim.viz.scene.Scene;

/** How far one object's course has been written into a scene. */
final class ShownCourse {
    /** So long (s) is the trail that is told at once of an object that is somewhere else. */
    private static final double TRAIL = 60;

    /** So many states of it are told at most. */
    private static final int MOST = 6000;

    private final Course course;
    private final Scene scene;
    private boolean shown;
    private boolean isNew;
    private int state;
    private int forces;
    private int marks;
    private int levels;

    ShownCourse(Course course, Scene scene) {
        this.course = course;
        this.scene = scene;
    }

    /** Takes it out of the scene if it is not there at a time (s). */
    void leave(double time) {
        if (shown && !course.isThere(time)) {
            scene.remove(course.id());
            shown = false;
        }
    }

    /** Shows it as it is at a time (s), if it is there then; all is told anew if time went back. */
    void show(double time, boolean back) {
        if (!course.isThere(time)) {
            return;
        }
        isNew = !shown;
        showObject(time);
        shown = true;
        showMotion(time, back);
        showForces(time);
        showMark(time);
    }

    private void showObject(double time) {
        int told = course.toldUntil(time);
        if (isNew || told != levels) {
            scene.add(course.objectAt(time));
            levels = told;
            forces = -1;
        }
    }

    /** The scene has the state before a time and the one after it, and what lies between. */
    private void showMotion(double time, boolean back) {
        Track track = course.track();
        int to = Math.min(track.times().at(time) + 1, track.times().count() - 1);
        if (to < 0) {
            return;
        }
        if (isNew || back || to - state > MOST) {
            int from = track.times().at(track.times().get(to) - TRAIL);
            state = Math.max(Math.max(from, to - MOST), 0);
            scene.jump(course.id(), track.motion(state));
            marks = 0;
        }
        while (state < to) {
            state++;
            scene.move(course.id(), track.motion(state));
        }
    }

    private void showForces(double time) {
        int count = course.forces().countUntil(time);
        if (count != forces) {
            forces = count;
            scene.setForces(course.id(), course.forces().get(count - 1));
        }
    }

    private void showMark(double time) {
        int count = course.marks().countUntil(time);
        if (count != marks) {
            marks = count;
            if (count > 0) {
                int last = count - 1;
                scene.measure(course.id(), course.marks().time(last), course.marks().get(last));
            }
        }
    }
}
