package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.OddRun;
import org.auvsim.diagnosis.search.RunByRun;
import org.auvsim.diagnosis.search.Search;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Why no cause explains runs, where that can be seen.
 *
 * @param notice what is to be said of it
 * @param isMisreading whether the runs are told in another way than they were read
 */
record LikelyReason(String notice, boolean isMisreading) {
    private static LikelyReason other(String notice) {
        return new LikelyReason(notice, false);
    }

    private static LikelyReason misreading(String notice) {
        return new LikelyReason(notice, true);
    }

    /**
     * The first that can be seen.
     *
     * @param heldOut the model as it is believed, on the runs that judge
     */
    static Optional<LikelyReason> of(Search.Found found, Judged heldOut, Course course) {
        List<Misses> data = new ArrayList<>(found.none().fit().data());
        data.addAll(heldOut.fit().data());
        List<MeasuredRun> runs = data.stream().map(Misses::run).toList();
        RunByRun byRun = new RunByRun(found.stepping(), data, found.noise(), course);
        return new SureStarts(found.stepping(), runs, found.noise(), course)
                .notice()
                .or(() -> byRun.notice(found.byRun()))
                .or(() -> OddRun.notice(found.none(), heldOut))
                .map(LikelyReason::other)
                .or(() -> found.misreading().notice().map(LikelyReason::misreading))
                .or(() -> MissedAlone.notice(found.none(), found.noise()).map(LikelyReason::other));
    }
}
