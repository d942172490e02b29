package org.auvsim.auvsml.run;

/** What a measured run is there for. */
public enum RunRole {
    /** What a model lacks is looked for in it. */
    FIT,
    /** It only judges what was found. */
    HOLDOUT
}
