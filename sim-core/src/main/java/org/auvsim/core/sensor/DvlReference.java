package org.auvsim.core.sensor;

/** Against what a Doppler log measures. */
public enum DvlReference {
    /** The bottom, or something else that is fixed. */
    BOTTOM,
    /** The water at its place. */
    WATER
}
