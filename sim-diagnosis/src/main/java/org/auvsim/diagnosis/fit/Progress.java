package org.auvsim.diagnosis.fit;

/** Is told how far a diagnosis is, and may stop it. Called by one thread at a time. */
@FunctionalInterface
public interface Progress {
    /** Tells nobody and never stops. */
    Progress SILENT = (stage, share) -> true;

    /**
     * Called now and then.
     *
     * @param stage what is being done, for people
     * @param share of all the work that is done, 0 to 1
     * @return whether to go on; if not, the diagnosis ends with the best that it has so far
     */
    boolean at(String stage, double share);
}
