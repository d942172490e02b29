package org.auvsim.diagnosis.result;

/** What a diagnosis comes to. */
public enum Verdict {
    /** Something is wrong with the model, and causes were found that explain it. */
    EXPLAINED,
    /** Nothing is wrong that the data could show. */
    NONE,
    /** Something is wrong, and no known cause explains it. */
    UNEXPLAINED,
    /** The search was stopped before any cause was tried: nothing can be said. */
    UNDECIDED
}
