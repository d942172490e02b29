package org.auvsim.viz.source;

/** The course of time of a recording, from any thread. */
public interface Playback {
    /** The world's time at its beginning (s). */
    double start();

    /** The world's time at its end (s). */
    double end();

    /** The world's time that is shown (s). */
    double time();

    /** Shows another time (s), within the recording. */
    void seek(double time);

    /** Goes on by so many recorded steps, or back; time then stands still. */
    void step(int steps);

    /** Whether time goes on by itself. */
    boolean isPlaying();

    /** Lets time go on, from the beginning if it is at the end, or stand still. */
    void play(boolean on);

    /** World seconds a second. */
    double rate();

    /** Lets time go on so fast (world seconds a second), above 0. */
    void rate(double rate);
}
