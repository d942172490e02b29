package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Approximation;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Discrepancy;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Sentence;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.StringJoiner;
import java.util.stream.IntStream;

/**
 * Examines measured runs: searches causes with some, judges them with others, and says what it is.
 */
public final class Examination {
    /** Share of the work that is done once all runs have been searched, where that is needed. */
    private static final double ALL_SEARCHED = 0.98;

    /** Errors that are such a share of those before are worth a model that explains nothing. */
    private static final double NEARER = 0.5;

    private static final String NO_GAIN =
            "held-out runs are predicted as well without what was found: it matters to runs of the"
                    + " fit alone; if nothing else was there, their start may not have been found,"
                    + " as that of a body which nothing rights: shorter parts (--parts SECONDS)"
                    + " tell";

    private final BelievedModel model;
    private final List<MeasuredRun> fit;
    private final List<MeasuredRun> heldOut;
    private final List<Cause> causes;
    private final long seed;
    private final Optional<Arena.Contest> contest;
    private final Course course;

    /**
     * Of runs that are searched with and runs that only judge.
     *
     * @param contest by which models are found; empty: by what causes leave in the data
     */
    public Examination(
            BelievedModel model,
            List<MeasuredRun> fit,
            List<MeasuredRun> heldOut,
            List<Cause> causes,
            long seed,
            Optional<Arena.Contest> contest,
            Progress progress) {
        this.model = model;
        this.fit = fit;
        this.heldOut = heldOut;
        this.causes = causes;
        this.seed = seed;
        this.contest = contest;
        this.course = new Course(progress);
    }

    /**
     * What was found, and how held-out runs judge it.
     *
     * @param before the model as it was believed, on the held-out runs
     * @param after what was found on them
     * @param passes whether it holds there, or where all runs were searched with, for each by the
     *     others
     * @param agrees whether they want the same numbers
     */
    private record Judgement(
            Search.Found found,
            Trial trial,
            Judged before,
            Judged after,
            boolean passes,
            boolean agrees) {
        static Judgement of(Search.Found found, Trial trial) {
            Judged best = found.best();
            Judged before = trial.prediction(Hypothesis.NONE);
            Judged after = best.isNone() ? before : trial.prediction(best.fit().hypothesis());
            if (!best.isWhite()) {
                return new Judgement(found, trial, before, after, false, false);
            }
            Judged adjusted = Trial.adjusted(best, after, new Uncertainty(best).knowledge());
            boolean passes = Trial.passes(best, before, after, adjusted);
            boolean agrees = passes && Agreement.of(adjusted);
            return new Judgement(found, trial, before, after, passes, agrees);
        }

        /** The same of what all runs said, which was believed. */
        Judgement convinced(Search.Found all) {
            Hypothesis best = all.best().fit().hypothesis();
            return new Judgement(all, trial, before, trial.prediction(best), true, true);
        }

        /**
         * Where held-out runs do not bear out what was found: that nothing was, if the model as it
         * was believed leaves nothing but noise in all runs.
         */
        Judgement orAsBelieved() {
            Judged none = found.none();
            boolean isNone =
                    !passes && none.isWhite() && Trial.passes(none, before, before, before);
            return isNone
                    ? new Judgement(found.nothing(), trial, before, before, true, true)
                    : this;
        }

        /** Whether the fit is content and the held-out runs are not. */
        boolean isOfTwoMinds() {
            return found.best().isWhite() && !agrees;
        }

        /** Whether what all runs say is something else than what those of the fit said. */
        boolean isNews(Search.Found all) {
            List<Cause> before = found.best().fit().hypothesis().causes();
            List<Cause> now = all.best().fit().hypothesis().causes();
            return !passes || !Set.copyOf(before).equals(Set.copyOf(now));
        }

        private Verdict verdict() {
            if (!passes) {
                return Verdict.UNEXPLAINED;
            }
            return found.best().isNone() ? Verdict.NONE : Verdict.EXPLAINED;
        }
    }

    /** What the runs say of the model. */
    public Diagnosis diagnosis() {
        Search.Found found = new Search(model, fit, causes, contest, course).found();
        course.at("judging by held-out runs", Search.END);
        Judgement judgement =
                Judgement.of(found, new Trial(found.stepping(), heldOut, found.noise()));
        if (judgement.isOfTwoMinds() && areAsLong(fit, heldOut) && course.goesOn()) {
            Search.Found all =
                    new Search(model, allRuns(), causes, contest, course.more(ALL_SEARCHED))
                            .found();
            LeaveOneOut turns = new LeaveOneOut(all.best(), course);
            if (isConvincing(all, found, turns) && judgement.isNews(all)) {
                return diagnosis(judgement.convinced(all), Optional.of(turns));
            }
        }
        return diagnosis(judgement.orAsBelieved(), Optional.empty());
    }

    /**
     * Whether all runs can be searched together. They cannot where those of the fit were cut into
     * parts and the held-out ones were not: so far ahead the model was not to predict.
     */
    static boolean areAsLong(List<MeasuredRun> fit, List<MeasuredRun> heldOut) {
        return fit.stream().noneMatch(Examination::isPart)
                || heldOut.stream().allMatch(Examination::isPart);
    }

    private static boolean isPart(MeasuredRun run) {
        return run.whole().size() > run.size();
    }

    /**
     * Whether what all runs say can be believed, though none was held out: what had to be given up
     * for it must be made up for by each run, left out in turn, where they can judge one another.
     */
    private boolean isConvincing(Search.Found all, Search.Found ofFit, LeaveOneOut turns) {
        Judged best = all.best();
        return !best.isNone()
                && best.isWhite()
                && (ofFit.best().isNone()
                        || !LeaveOneOut.canJudge(allRuns())
                        || Trial.holdsLeftOut(all.none(), best, turns));
    }

    private List<MeasuredRun> allRuns() {
        List<MeasuredRun> all = new ArrayList<>(fit);
        all.addAll(heldOut);
        return all;
    }

    /**
     * What was found, in all its parts.
     *
     * @param turns where the fit runs alone had nothing to say and all were searched with
     */
    private Diagnosis diagnosis(Judgement judgement, Optional<LeaveOneOut> turns) {
        boolean usedHeldOut = turns.isPresent();
        Search.Found found = judgement.found();
        Trial trial = judgement.trial();
        Judged best = found.best();
        Judged before = judgement.before();
        Judged after = judgement.after();
        Verdict verdict = judgement.verdict();
        boolean isExplained = verdict == Verdict.EXPLAINED;
        List<Finding> selected = isExplained ? Findings.of(found) : List.of();
        double share = Findings.share(found.none(), best);
        List<Alternative> alternatives =
                found.competitors().stream()
                        .filter(other -> !other.isNone())
                        .map(other -> Alternatives.alternative(best, other))
                        .toList();
        Map<Channel, Gain> gains =
                turns.map(of -> Trial.leftOut(asBelieved(found), of, found.noise()))
                        .orElseGet(() -> trial.gains(before, after));
        Optional<Discrepancy> discrepancy =
                verdict == Verdict.UNEXPLAINED
                        ? Optional.of(Misfit.largest(best, share))
                        : Optional.empty();
        Sentence sentence = new Sentence(gains, usedHeldOut);
        String words =
                switch (verdict) {
                    case EXPLAINED -> explained(sentence, found, selected, share, alternatives);
                    case NONE -> sentence.none();
                    case UNEXPLAINED -> sentence.unexplained(discrepancy);
                };
        return new Diagnosis(
                verdict,
                words,
                model.body(),
                selected,
                causes.size(),
                Ranking.of(found),
                alternatives,
                found.noise().byChannel(),
                gains,
                trial.horizons(best.fit().variant()),
                usedHeldOut,
                runs(found, best, before, after),
                discrepancy,
                verdict == Verdict.UNEXPLAINED ? approximation(found, gains) : Optional.empty(),
                Optional.empty(),
                new Menu(best.fit(), found.noise()).next(best, found.competitors()),
                found.traces().identifiability(best.fit().hypothesis().causes()),
                model.extended(isExplained ? best.fit().variant() : model.variant()),
                notices(found, verdict, gains),
                seed,
                course.goesOn());
    }

    private LeaveOneOut asBelieved(Search.Found found) {
        return new LeaveOneOut(found.none(), course);
    }

    private static String explained(
            Sentence sentence,
            Search.Found found,
            List<Finding> selected,
            double share,
            List<Alternative> alternatives) {
        String words = sentence.explained(selected, share, alternatives);
        return DragLaw.unsettled(found, alternatives)
                .map(other -> Sentence.unsettled(words, other.cause(), other.share()))
                .orElse(words);
    }

    /** The best that was tried, where it is much nearer to the held-out runs in all they tell. */
    private Optional<Approximation> approximation(Search.Found found, Map<Channel, Gain> gains) {
        boolean isNearer =
                !gains.isEmpty()
                        && gains.values().stream()
                                .allMatch(gain -> gain.after() < NEARER * gain.before());
        return found.best().isNone() || !isNearer
                ? Optional.empty()
                : Optional.of(
                        new Approximation(
                                Findings.unsure(found),
                                model.extended(found.best().fit().variant())));
    }

    /** Steps that follow data which no model fits tell of that data, not of the scenario. */
    private List<String> notices(Search.Found found, Verdict verdict, Map<Channel, Gain> gains) {
        List<String> notices = new ArrayList<>();
        if (verdict == Verdict.EXPLAINED && !gains.isEmpty() && !Sentence.isGain(gains)) {
            notices.add(NO_GAIN);
        }
        double stated = model.scenario().timeStep().delta();
        double used = found.stepping().fine().scenario().timeStep().delta();
        if (used < stated && verdict != Verdict.UNEXPLAINED) {
            notices.add(
                    ("the scenario's time step of %s s is too long for this data: steps of %s"
                                    + " s were made, which a simulation needs, too")
                            .formatted(stated, used));
        }
        String still = still(found.noise());
        if (!still.isEmpty()) {
            notices.add(
                    "what never changes in any run tells nothing and counts as not measured: "
                            + still);
        }
        allRuns().forEach(run -> notices.addAll(stuck(run, found.noise())));
        for (Misses of : Misses.of(allRuns(), found.noise())) {
            HeavyTails.notice(of.run(), of.rows(), found.noise()).ifPresent(notices::add);
        }
        return notices;
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
                            "%s: %s %s never changes, though it does in other runs; if its sensor was dead, leave the run out or empty the cells"
                                    .formatted(
                                            run.name(),
                                            HeavyTails.name(channel),
                                            "xyz".charAt(axis)));
                }
            }
        }
        return stuck;
    }

    /** The axes that were measured and never change. */
    private String still(Noise noise) {
        StringJoiner still = new StringJoiner(", ");
        for (Channel channel : Channel.values()) {
            for (int axis = 0; axis < 3; axis++) {
                int of = axis;
                boolean isMeasured = fit.stream().anyMatch(run -> run.measures(channel, of));
                if (isMeasured && !noise.tells(channel, axis)) {
                    still.add(HeavyTails.name(channel) + " " + "xyz".charAt(axis));
                }
            }
        }
        return still.toString();
    }

    private List<DiagnosedRun> runs(Search.Found found, Judged best, Judged before, Judged after) {
        List<DiagnosedRun> runs = new ArrayList<>();
        runs.addAll(
                runs(found, found.none(), best, best.fit().variant(), false)
                        .subList(0, fit.size()));
        runs.addAll(runs(found, before, after, best.fit().variant(), true));
        return runs;
    }

    private List<DiagnosedRun> runs(
            Search.Found found, Judged before, Judged after, Variant variant, boolean areHeldOut) {
        List<RigidMotion[]> motionBefore = before.fit().motions();
        List<RigidMotion[]> motionAfter = after.fit().motions();
        List<Misses> data = after.fit().data();
        return IntStream.range(0, data.size())
                .parallel()
                .mapToObj(
                        r -> {
                            Misses of = data.get(r);
                            return new DiagnosedRun(
                                    of.run(),
                                    areHeldOut,
                                    told(of.run(), model.variant(), motionBefore.get(r)),
                                    told(of.run(), variant, motionAfter.get(r)),
                                    MissingForce.along(
                                            found.stepping(), variant, of, found.noise()));
                        })
                .toList();
    }

    /** As the sensors would tell. */
    private static List<RigidMotion> told(MeasuredRun run, Variant variant, RigidMotion[] motion) {
        return List.of(variant.sensing().of(motion, run, 0, motion.length));
    }
}
