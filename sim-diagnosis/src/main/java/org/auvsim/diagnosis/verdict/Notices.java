package org.auvsim.diagnosis.verdict;

import org.auvsim.core.entity.Behavior;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.HeavyTails;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.StatedStarts;
import org.auvsim.diagnosis.result.Axis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.Search;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.StringJoiner;

/** What is to be known of runs, and limits what they say. */
final class Notices {
    private static final String NO_GAIN =
            "held-out runs are predicted just as well without what was found: it matters only in"
                    + " the fitted runs. If nothing else was there, the start of a fitted run may"
                    + " not have been found, as with a body that nothing rights; try shorter parts"
                    + " (--parts SECONDS)";

    private static final String TOO_FEW =
            "too few numbers to tell their noise, so treated as not measured unless their standard"
                    + " deviations are stated (as sd_x): ";

    /** Horizontal velocities (m/s, world) among the numbers of a motion. */
    private static final int EAST = 6;

    private static final int NORTH = 7;

    private final BelievedModel model;
    private final List<MeasuredRun> fit;
    private final List<MeasuredRun> judging;
    private final List<MeasuredRun> all;

    /** Of a model, the runs it was searched with, and those that judge. */
    Notices(BelievedModel model, List<MeasuredRun> fit, List<MeasuredRun> heldOut) {
        this.model = model;
        this.fit = fit;
        this.judging = heldOut;
        this.all = new ArrayList<>(fit);
        all.addAll(heldOut);
    }

    /**
     * Steps that follow data which no model fits tell of that data, not of the scenario.
     *
     * @param heldOut what was found on the runs that judge
     * @param selected the causes that are named
     * @param reason why nothing explains the runs, where that can be seen
     */
    List<String> of(
            Search.Found found,
            Judged heldOut,
            Verdict verdict,
            List<Finding> selected,
            Foretold foretold,
            Optional<LikelyReason> reason) {
        List<String> notices = new ArrayList<>(overruled());
        leftOut().ifPresent(notices::add);
        boolean isTested = !foretold.gains().isEmpty();
        if (verdict == Verdict.EXPLAINED && isTested && !foretold.isBetter()) {
            notices.add(UnjudgedMoment.notice(selected, judging).orElse(NO_GAIN));
        }
        double stated = model.scenario().timeStep().delta();
        double used = found.stepping().fine().scenario().timeStep().delta();
        if (used < stated && verdict != Verdict.UNEXPLAINED) {
            notices.add(
                    ("the scenario's time step of %s s is too long for this data: steps of %s"
                                    + " s were made, which a simulation needs, too")
                            .formatted(stated, used));
        }
        String still = unmeasured(found.noise(), false);
        if (!still.isEmpty()) {
            notices.add("never changes in any run, so treated as not measured: " + still);
        }
        String few = unmeasured(found.noise(), true);
        if (!few.isEmpty()) {
            notices.add(TOO_FEW + few);
        }
        all.forEach(run -> notices.addAll(stuck(run, found.noise())));
        notices.addAll(LooseStrength.notices(selected));
        UnseenSpin.notice(fit, selected).ifPresent(notices::add);
        Feet.notice(selected).ifPresent(notices::add);
        Hypothesis best = found.best().fit().hypothesis();
        SpinUp.notice(model, fit, best).ifPresent(notices::add);
        if (verdict == Verdict.EXPLAINED || SlowSwing.isTrend(fit, best)) {
            notices.addAll(SlowSwing.notices(fit, best));
        }
        if (verdict == Verdict.EXPLAINED) {
            QuarterTurn.notice(best).ifPresent(notices::add);
        }
        assumedSpeed(verdict).ifPresent(notices::add);
        if (verdict != Verdict.EXPLAINED) {
            all.forEach(run -> StatedStarts.notice(run, found.noise()).ifPresent(notices::add));
        }
        reason.map(LikelyReason::notice).ifPresent(notices::add);
        found.noise().notice().ifPresent(notices::add);
        notices.addAll(new NoisierRuns(found.noise(), found.best(), heldOut).notices());
        for (Misses of : Misses.of(all, found.noise())) {
            HeavyTails.notice(of.run(), of.rows(), found.noise()).ifPresent(notices::add);
        }
        return notices;
    }

    /**
     * That a body begins as fast as in the scenario where nothing tells: if it rests there, that is
     * of interest only where something is wrong.
     */
    private Optional<String> assumedSpeed(Verdict verdict) {
        Vec3 start = model.start().velocity();
        double speed = Math.hypot(start.x(), start.y());
        List<String> names =
                all.stream().filter(Notices::hidesItsSpeed).map(MeasuredRun::name).toList();
        boolean mayMatter = speed > 0 || (verdict != Verdict.NONE && mayMoveSideways());
        return names.isEmpty() || !mayMatter
                ? Optional.empty()
                : Optional.of(
                        "nothing that is measured tells how fast %s begin%s: %s; what began otherwise may look like %s: state its start"
                                .formatted(
                                        String.join(", ", names),
                                        names.size() == 1 ? "s" : "",
                                        speed > 0
                                                ? "at the scenario's %s m/s"
                                                        .formatted(Numbers.rounded(speed))
                                                : "at rest, as in the scenario",
                                        speed > 0 ? "a current" : "a cause"));
    }

    /** Whether no mount keeps the body where it is, or above it. */
    private boolean mayMoveSideways() {
        double[] sideways = new double[RigidMotion.SIZE];
        sideways[EAST] = 1;
        sideways[NORTH] = 1;
        double[] free = model.startable(sideways);
        return free[EAST] != 0 || free[NORTH] != 0;
    }

    /** Whether neither a statement nor anything measured tells how fast it goes horizontally. */
    private static boolean hidesItsSpeed(MeasuredRun run) {
        return run.start().isEmpty()
                && !run.measures(Channel.VELOCITY)
                && !run.measures(Channel.POSITION, 0)
                && !run.measures(Channel.POSITION, 1);
    }

    /** Others that move: nobody measured how. */
    private Optional<String> leftOut() {
        List<String> names = model.leftOut();
        return names.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "left out, as they move and were not measured: '%s'; what they do to '%s' when they meet is no part of the model here"
                                .formatted(String.join("', '", names), model.body()));
    }

    /** Behaviors of the scenario that do not act, in all runs or in some. */
    private List<String> overruled() {
        Map<List<String>, List<String>> runs = new LinkedHashMap<>();
        for (MeasuredRun run : all) {
            List<String> names = model.overruledBy(run).stream().map(Behavior::name).toList();
            if (!names.isEmpty()) {
                runs.computeIfAbsent(names, _ -> new ArrayList<>()).add(run.name());
            }
        }
        List<String> notices = new ArrayList<>();
        runs.forEach((names, where) -> notices.add(overruled(names, where)));
        return notices;
    }

    private String overruled(List<String> behaviors, List<String> runs) {
        boolean isOne = behaviors.size() == 1;
        boolean isEverywhere = runs.size() == all.size();
        return "the scenario's '%s' %s not act%s: %s have the commands that %s would give"
                .formatted(
                        String.join("', '", behaviors),
                        isOne ? "does" : "do",
                        isEverywhere ? "" : " in " + String.join(", ", runs),
                        isEverywhere ? "the runs" : "they",
                        isOne ? "it" : "these");
    }

    /** What never changes in a run, but does in others. */
    private static List<String> stuck(MeasuredRun run, Noise noise) {
        List<String> stuck = new ArrayList<>();
        for (Channel channel : Channel.values()) {
            for (int axis = 0; axis < 3; axis++) {
                if (run.measures(channel, axis)
                        && noise.tells(channel, axis)
                        && !Noise.changes(run, channel, axis)) {
                    stuck.add(
                            "%s: %s never changes, though it does in other runs; if its sensor was dead, leave the run out or empty the cells"
                                    .formatted(
                                            run.name(),
                                            Axis.of(run, channel, axis).brief(channel)));
                }
            }
        }
        return stuck;
    }

    /** The axes that were measured and tell nothing, of those that change or of the others. */
    private String unmeasured(Noise noise, boolean change) {
        StringJoiner unmeasured = new StringJoiner(", ");
        for (Channel channel : Channel.values()) {
            for (int axis = 0; axis < 3; axis++) {
                int of = axis;
                if (!noise.tells(channel, axis)
                        && change == fit.stream().anyMatch(r -> Noise.changes(r, channel, of))) {
                    fit.stream()
                            .filter(run -> run.measures(channel, of))
                            .map(run -> Axis.of(run, channel, of).brief(channel))
                            .distinct()
                            .forEach(unmeasured::add);
                }
            }
        }
        return unmeasured.toString();
    }
}
