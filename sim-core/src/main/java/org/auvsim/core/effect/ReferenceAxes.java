package org.auvsim.core.effect;

/** Body axes in which published coefficients are given. */
public enum ReferenceAxes {
    /** Forward, left, up: those of the simulator (ROS REP 103). */
    FLU,

    /** Forward, right, down: those of marine publications (SNAME 1950). */
    FRD
}
