package org.auvsim.diagnosis.verdict;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.LeaveOneOut;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.LocalMotion;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Approximation;
import org.auvsim.diagnosis.result.Conclusion;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Discrepancy;
import org.auvsim.diagnosis.result.Evidence;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Moments;
import org.auvsim.diagnosis.result.Prediction;
import org.auvsim.diagnosis.result.Sentence;
import org.auvsim.diagnosis.result.Sentences;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.Alternatives;
import org.auvsim.diagnosis.search.Search;
import org.auvsim.diagnosis.search.Way;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Examines measured runs: searches causes with some, judges them with others, and says what it is.
 */
public final class Examination {
    /** Share of the work that is done once all runs have been searched, where that is needed. */
    private static final double ALL_SEARCHED = 0.98;

    /** So many times as long as parts of runs that were fitted is too far ahead for the model. */
    private static final double FAR_LONGER = 1.5;

    /** Share of the work that is done once it is known what is told. */
    private static final double END = 0.99;

    /** Errors that are such a share of those before are worth a model that explains nothing. */
    private static final double NEARER = 0.5;

    /** So many causes imitate much, and so many runs can tell whether they do. */
    private static final int SEVERAL = 3;

    /** Others may be such a share of theirs, as those that were no larger than noise. */
    private static final double NO_FARTHER = 1.1;

    private final BelievedModel model;
    private final List<MeasuredRun> fit;
    private final List<MeasuredRun> heldOut;
    private final List<Cause> causes;
    private final long seed;
    private final Way way;
    private final Course course;

    /**
     * Of runs that are searched with and runs that only judge.
     *
     * @param way how they are searched
     */
    public Examination(
            BelievedModel model,
            List<MeasuredRun> fit,
            List<MeasuredRun> heldOut,
            List<Cause> causes,
            long seed,
            Way way,
            Progress progress) {
        this.model = model;
        this.fit = begun(fit);
        this.heldOut = begun(heldOut);
        this.causes = causes;
        this.seed = seed;
        this.way = way;
        this.course = new Course(progress);
    }

    private List<MeasuredRun> begun(List<MeasuredRun> runs) {
        return runs.stream().map(run -> LocalMotion.begun(run, model)).toList();
    }

    /** What the runs say of the model. */
    public Diagnosis diagnosis() {
        return diagnosis(List.of());
    }

    /** The same, with what imitates the misfit best where nothing that is known explains it. */
    public Diagnosis diagnosis(List<Imitator> imitators) {
        Search.Found found = new Search(model, fit, causes, way, course).found();
        course.at("judging by held-out runs", Search.END);
        Trial trial = new Trial(found.stepping(), heldOut, found.noise());
        Judgement judgement = Judgement.of(found, trial);
        boolean isDoubted = judgement.isOfTwoMinds() || new Rivals(found, trial, course).areAhead();
        if (isDoubted && areAsLong(fit, heldOut) && course.goesOn()) {
            Search.Found all =
                    new Search(model, allRuns(), causes, way, course.more(ALL_SEARCHED)).found();
            if (judgement.isNews(all) && !all.best().isNone()) {
                LeaveOneOut turns = new LeaveOneOut(all.best(), course);
                Foretold byTurns = Foretold.byTurns(asBelieved(all), turns, all.noise());
                if (isConvincing(all, found, turns, byTurns)) {
                    return diagnosis(judgement.convinced(all), Optional.of(byTurns));
                }
            }
        }
        Diagnosis diagnosis = diagnosis(judgement.orAsBelieved(), Optional.empty());
        ImitationTrial ofImitators =
                new ImitationTrial(found.stepping(), heldOut, found.noise(), course);
        return imitated(diagnosis, ofImitators, imitators);
    }

    /** Only once the search has come to its end: a known cause is worth more. */
    private Diagnosis imitated(
            Diagnosis diagnosis, ImitationTrial trial, List<Imitator> imitators) {
        if (diagnosis.verdict() != Verdict.UNEXPLAINED
                || !diagnosis.isComplete()
                || !course.at("looking for a formula or a field", END)) {
            return diagnosis;
        }
        return imitators.stream()
                .flatMap(imitator -> imitator.proposal(diagnosis, trial).stream())
                .min(Comparator.comparingDouble(proposal -> proposal.heldOut().after()))
                .map(diagnosis::proposing)
                .orElse(diagnosis);
    }

    /**
     * Whether all runs can be searched together. They cannot where those of the fit were cut into
     * parts and the held-out ones are far longer: so far ahead the model was not to predict.
     */
    static boolean areAsLong(List<MeasuredRun> fit, List<MeasuredRun> heldOut) {
        return fit.stream().noneMatch(MeasuredRun::isPart)
                || longest(heldOut) <= FAR_LONGER * longest(fit);
    }

    private static double longest(List<MeasuredRun> runs) {
        return runs.stream().mapToDouble(MeasuredRun::duration).max().orElse(0);
    }

    /**
     * Whether what all runs say can be believed, though none was held out: where they can judge one
     * another, much of it must be foretold of each by the others, and what had to be given up for
     * it must be made up for by each.
     */
    private boolean isConvincing(
            Search.Found all, Search.Found ofFit, LeaveOneOut turns, Foretold byTurns) {
        Judged best = all.best();
        return best.isWhite()
                && !Undoing.isIn(all.none(), best.fit().hypothesis())
                && (!LeaveOneOut.canJudge(allRuns())
                        || (areForetold(all, turns, byTurns)
                                && (ofFit.best().isNone()
                                        || Trial.holdsLeftOut(all.none(), best, turns))));
    }

    /**
     * Whether much of what the causes gain is foretold of each run; of a sum of several, which
     * imitates much, of what each gains beside the others, too, unless there is only one run to
     * foretell it.
     */
    private boolean areForetold(Search.Found all, LeaveOneOut turns, Foretold byTurns) {
        int causes = all.best().size();
        return byTurns.isMuchOf(all.none(), all.best())
                && (causes < SEVERAL
                        || allRuns().size() < SEVERAL
                        || IntStream.range(0, causes)
                                .mapToObj(all::without)
                                .allMatch(others -> isForetold(all, others, turns)));
    }

    private boolean isForetold(Search.Found all, Judged others, LeaveOneOut turns) {
        LeaveOneOut fewer = new LeaveOneOut(others, course);
        return !turns.restsOnOneRun(fewer)
                && Foretold.byTurns(fewer, turns, all.noise()).isMuchOf(others, all.best());
    }

    private List<MeasuredRun> allRuns() {
        List<MeasuredRun> all = new ArrayList<>(fit);
        all.addAll(heldOut);
        return all;
    }

    /**
     * What was found, in all its parts.
     *
     * @param byTurns each run by the others, where what those of the fit said was in doubt and all
     *     were searched with
     */
    private Diagnosis diagnosis(Judgement judged, Optional<Foretold> byTurns) {
        Hypothesis selected = judged.found().best().fit().hypothesis();
        Judgement judgement = SlowSwing.isTrend(fit, selected) ? judged.denied() : judged;
        boolean usedHeldOut = byTurns.isPresent();
        Search.Found found = judgement.found();
        Judged best = found.best();
        Judged after = judgement.after();
        Verdict verdict = judgement.verdict();
        boolean isExplained = verdict == Verdict.EXPLAINED;
        List<Alternative> alternatives = isExplained ? alternatives(found) : List.of();
        Foretold foretold = byTurns.orElseGet(judgement::foretold);
        Sentences sentences =
                new Sentences(foretold.gains(), usedHeldOut, foretold.isBetter())
                        .with(new Moments(allRuns()));
        Conclusion conclusion = conclusion(judgement, alternatives, foretold.gains(), sentences);
        Prediction prediction =
                new Prediction(
                        found.noise().byChannel(),
                        foretold.gains(),
                        course.goesOn()
                                ? judgement.trial().horizons(after, best.fit().variant())
                                : List.of(),
                        usedHeldOut);
        List<DiagnosedRun> runs = runs(judgement);
        Optional<LikelyReason> reason =
                verdict == Verdict.UNEXPLAINED
                        ? LikelyReason.of(found, judgement.before(), course)
                        : Optional.empty();
        Diagnosis diagnosis =
                new Diagnosis(
                        model.body(),
                        conclusion,
                        new Evidence(
                                causes.size(),
                                Ranking.of(found, verdict != Verdict.UNEXPLAINED),
                                alternatives,
                                found.traces().identifiability(best.fit().hypothesis().causes()),
                                new Menu(best.fit(), found.noise())
                                        .next(best, found.competitors())),
                        prediction,
                        runs,
                        extended(
                                isExplained ? best.fit().variant() : model.variant(),
                                conclusion.selected()),
                        new Notices(model, fit, heldOut)
                                .of(found, after, verdict, conclusion.selected(), foretold, reason),
                        seed,
                        course.goesOn());
        boolean areMisread =
                reason.filter(LikelyReason::isMisreading).isPresent()
                        || (isExplained && QuarterTurn.notice(best.fit().hypothesis()).isPresent());
        return areMisread ? diagnosis.doubted() : diagnosis;
    }

    private Conclusion conclusion(
            Judgement judgement,
            List<Alternative> alternatives,
            Map<Channel, Gain> gains,
            Sentences sentences) {
        Search.Found found = judgement.found();
        double share = Findings.share(found.none(), found.best());
        return switch (judgement.verdict()) {
            case EXPLAINED -> {
                List<Finding> selected = Findings.of(found);
                Sentence words = sentences.explained(selected, share, alternatives);
                yield new Conclusion(
                        Verdict.EXPLAINED,
                        DragLaw.unsettled(found, alternatives)
                                .map(other -> words.unsettled(other.cause(), other.share()))
                                .orElse(words),
                        selected);
            }
            case NONE -> new Conclusion(Verdict.NONE, sentences.none(), List.of());
            case UNEXPLAINED -> {
                Optional<Discrepancy> seen =
                        Optional.of(Misfit.largest(judgement.inDoubt(), share));
                yield new Conclusion(
                        Verdict.UNEXPLAINED,
                        sentences.unexplained(seen),
                        List.of(),
                        seen,
                        approximation(found, gains),
                        Optional.empty());
            }
            case UNDECIDED ->
                    new Conclusion(Verdict.UNDECIDED, Sentences.stoppedAtOnce(), List.of());
        };
    }

    /** To what was found. */
    private static List<Alternative> alternatives(Search.Found found) {
        return found.competitors().stream()
                .filter(other -> !other.isNone())
                .sorted(Comparator.comparingDouble(Judged::logEvidence).reversed())
                .map(other -> Alternatives.alternative(found.best(), other))
                .toList();
    }

    private LeaveOneOut asBelieved(Search.Found found) {
        return new LeaveOneOut(found.none(), course);
    }

    /**
     * The best that was tried, where it is much nearer to the held-out runs, and nowhere farther.
     */
    private Optional<Approximation> approximation(Search.Found found, Map<Channel, Gain> gains) {
        return found.best().isNone() || !isNearer(gains.values())
                ? Optional.empty()
                : Optional.of(approximation(found));
    }

    /** Whether some error is much smaller with what was found, and none is larger. */
    static boolean isNearer(Collection<Gain> gains) {
        return gains.stream().anyMatch(gain -> gain.after() < NEARER * gain.before())
                && gains.stream().allMatch(gain -> gain.after() < NO_FARTHER * gain.before());
    }

    private Approximation approximation(Search.Found found) {
        List<Finding> causes = Findings.unsure(found);
        return new Approximation(causes, extended(found.best().fit().variant(), causes));
    }

    /** What begins in UNIX time would never come in a world that begins at 0. */
    private Scenario extended(Variant variant, List<Finding> causes) {
        Scenario extended = model.extended(variant);
        Moments moments = new Moments(allRuns());
        return moments.areFar() && causes.stream().anyMatch(Moments::isTimed)
                ? extended.beginningAt(moments.begin())
                : extended;
    }

    private List<DiagnosedRun> runs(Judgement judgement) {
        course.at("looking at what is left", END);
        Search.Found found = judgement.found();
        Judged best = found.best();
        Judged after = judgement.after();
        Variant variant = best.fit().variant();
        Fit believed = judgement.believedOfFit();
        List<DiagnosedRun> runs =
                new ArrayList<>(runs(found, believed, best, variant, false).subList(0, fit.size()));
        runs.addAll(runs(found, judgement.believedOfHeldOut(), after, variant, true));
        return runs;
    }

    private List<DiagnosedRun> runs(
            Search.Found found, Fit before, Judged after, Variant variant, boolean areHeldOut) {
        List<RigidMotion[]> motionBefore = before.motions();
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
                                            found.stepping(), variant, of, found.noise(), course),
                                    of.uncounted());
                        })
                .toList();
    }

    /** As the sensors would tell. */
    private static List<RigidMotion> told(MeasuredRun run, Variant variant, RigidMotion[] motion) {
        return List.of(variant.sensing().of(motion, run, 0, motion.length));
    }
}
