package org.auvsim.diagnosis.search;

import static java.util.stream.Collectors.toSet;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Bounds;
import org.auvsim.diagnosis.fit.FirstOrder;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Gram;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Step;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.shooting.WindowBlock;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Says which causes promise to explain what a fit misses, all at once and without a simulation for
 * each set: by the columns of all of them along the measured motion. Long chains of windows see
 * slow effects, short ones are not led astray; both are asked.
 */
final class Screen {
    private static final int KEPT = 5;
    private static final int STARTS_OF_ONE = 2;

    /** So many sets of causes are continued by one more each. */
    private static final int CONTINUED = 12;

    /** Frequencies at which one that swings is begun. */
    private static final int PEAKS = 4;

    /** Where the search is thorough: starts of one cause, and of all together. */
    private static final int THOROUGH = 4;

    private static final int MOST_THOROUGH = 16;

    /**
     * Causes whose promise falls short of their price by no more than this are tried too, as
     * promises are first-order only.
     */
    private static final double LACKING = 30;

    /**
     * What changes no more than this of all that is predicted (standard deviations) is rounding.
     */
    private static final double TRACELESS = 1e-4;

    private final Fit base;
    private final List<Seed> seeds;
    private final List<Cause> swept;
    private final int own;
    private final Bounds bounds;
    private final Moves moves;
    private final List<List<WindowDerivatives>> derivatives;
    private final Outcome outcome;

    /** A set of causes that is worth a closer look, from blocks of so many windows on. */
    record Start(Fit fit, int perBlock, double promise) {
        List<Cause> causes() {
            return fit.hypothesis().causes();
        }
    }

    /** What a set of guesses promises, and the factors of all columns, own ones first. */
    private record Promise(List<Seed> set, List<Double> factors, double score) {
        /** The only one of a set of one. */
        Cause cause() {
            return set.getFirst().cause();
        }

        double[] factors(int from, int to) {
            return factors.subList(from, to).stream().mapToDouble(Double::doubleValue).toArray();
        }
    }

    /**
     * Screens causes beside those of a fit.
     *
     * @param outcome of the model as it is believed: how many numbers there are to explain
     */
    Screen(Fit base, List<Cause> causes, List<Seed.Guesses> guesses, Outcome outcome) {
        this.base = base;
        this.own = base.hypothesis().size();
        this.seeds = Seed.of(causes, guesses, own);
        this.swept =
                guesses.stream().filter(Seed.Guesses::isSwept).map(Seed.Guesses::cause).toList();
        this.bounds = bounds();
        this.moves = moves();
        this.derivatives = FirstOrder.derivatives(base, moves);
        this.outcome = outcome;
    }

    /** How far the number of each column may be moved. */
    private Bounds bounds() {
        DoubleStream ofSeeds =
                seeds.stream().flatMapToDouble(seed -> Arrays.stream(seed.numbers()));
        DoubleStream all = DoubleStream.concat(Arrays.stream(base.hypothesis().numbers()), ofSeeds);
        return Bounds.of(parameters(seeds), all.toArray());
    }

    private Moves moves() {
        Moves ofBase = base.hypothesis().moves(base.model().variant());
        List<Variant> variants = new ArrayList<>(ofBase.variants());
        List<Double> steps = new ArrayList<>(ofBase.steps());
        Variant variant = base.variant();
        for (Seed seed : seeds) {
            for (int c = 0; c < seed.guess().columns().size(); c++) {
                variants.add(seed.moved(variant, c));
                steps.add(seed.guess().steps().get(c));
            }
        }
        return new Moves(variants, steps);
    }

    /** How alike what causes do is, over whole runs. */
    Traces traces() {
        List<List<WindowBlock>> blocks = base.blocks(derivatives, base.longest());
        return new Traces(
                base.hypothesis(),
                Gram.of(blocks, moves.size()),
                seeds,
                cause -> cause.price(outcome.count(), outcome.independent()));
    }

    /** What the best of all causes promises where nothing is missed but noise. */
    Chance chance() {
        List<List<WindowBlock>> blocks = base.blocks(derivatives, base.longest());
        return Chance.of(Gram.of(blocks, moves.size()), this::bestPromise);
    }

    private double bestPromise(Gram gram) {
        double without = dropOfOwn(gram);
        return seeds.stream()
                .map(List::of)
                .mapToDouble(set -> promise(gram, columns(set), set, without).score())
                .filter(score -> score > 0)
                .max()
                .orElse(0);
    }

    /**
     * Sets of so many causes, from each level, where they promise most. All of one or two are
     * compared; larger ones are those of one cause fewer that promise most, each with one more.
     *
     * @param isNew those of which each set has one at least
     */
    List<Start> starts(int size, Predicate<Cause> isNew) {
        return starts(
                (blocks, isWhole) ->
                        switch (size) {
                            case 1 -> bestSingles(blocks, isWhole, isNew);
                            case 2 -> bestPairs(blocks, isNew, KEPT);
                            default -> bestSets(blocks, size, isNew);
                        });
    }

    /** Starts of each cause alone, from each level: one at least, several of what promises most. */
    List<Start> startsOfEach() {
        return starts(
                (blocks, isWhole) -> {
                    List<Promise> best = best(lackingLittle(blocks));
                    Set<Promise> starts = new LinkedHashSet<>(firstOfEach(best, 1, best.size()));
                    if (!isWhole) {
                        starts.addAll(firstOfEach(best, THOROUGH, MOST_THOROUGH));
                    }
                    return List.copyOf(starts);
                });
    }

    private List<Promise> lackingLittle(List<List<WindowBlock>> blocks) {
        return ofEachSeed(blocks).stream().filter(p -> p.score() > -LACKING).toList();
    }

    private List<Start> starts(BiFunction<List<List<WindowBlock>>, Boolean, List<Promise>> best) {
        List<Start> starts = new ArrayList<>();
        int longest = base.longest();
        int[] levels =
                IntStream.of(Math.max(1, longest / 32), Math.max(1, longest / 8), longest)
                        .distinct()
                        .toArray();
        for (int perBlock : levels) {
            List<List<WindowBlock>> blocks = base.blocks(derivatives, perBlock);
            List<Start> earlier = List.copyOf(starts);
            for (Promise promise : best.apply(blocks, perBlock == longest)) {
                if (earlier.stream().noneMatch(s -> isSame(s, promise, perBlock))) {
                    starts.add(start(blocks, promise, perBlock));
                }
            }
        }
        return starts;
    }

    /** What each column is of: own ones, then those of a set. */
    private List<Parameter> parameters(List<Seed> set) {
        List<Parameter> parameters = new ArrayList<>(base.hypothesis().parameters());
        for (Seed seed : set) {
            parameters.addAll(seed.parameters());
        }
        return parameters;
    }

    /** The same causes from the same blocks, or from other guesses that have no advantage. */
    private boolean isSame(Start start, Promise promise, int perBlock) {
        List<Cause> added =
                start.causes().subList(base.hypothesis().causes().size(), start.causes().size());
        return start.perBlock() == perBlock
                && added.equals(promise.set().stream().map(Seed::cause).toList())
                && start.promise() >= promise.score();
    }

    private Start start(List<List<WindowBlock>> blocks, Promise promise, int perBlock) {
        double[] change = new double[moves.size()];
        System.arraycopy(promise.factors(0, own), 0, change, 0, own);
        Hypothesis hypothesis = base.hypothesis().plus(promise.factors(0, own));
        int at = own;
        for (Seed seed : promise.set()) {
            int[] columns = seed.columns();
            double[] factors = promise.factors(at, at + columns.length);
            for (int i = 0; i < columns.length; i++) {
                change[columns[i]] = factors[i];
            }
            hypothesis = hypothesis.and(seed.cause(), seed.solved(factors));
            at += columns.length;
        }
        Fit fit = base.with(hypothesis, Step.windows(blocks, change));
        return new Start(fit, Math.min(2 * perBlock, base.longest()), promise.score());
    }

    /** All there are, if they are few: what one promises is true to first order only. */
    private List<Promise> bestSingles(
            List<List<WindowBlock>> blocks, boolean isWhole, Predicate<Cause> isNew) {
        boolean areFew = seeds.stream().map(Seed::cause).distinct().count() <= KEPT;
        double least = areFew ? Double.NEGATIVE_INFINITY : 0;
        List<Promise> promises =
                ofEachSeed(blocks).stream()
                        .filter(promise -> promise.score() > least)
                        .filter(promise -> isNew.test(promise.cause()))
                        .toList();
        return isWhole
                ? withPeaks(firstOfEach(best(promises), 1, KEPT), promises)
                : firstOfEach(best(promises), STARTS_OF_ONE, KEPT);
    }

    /**
     * With what swings begun at other frequencies, too, that promise more than those beside them:
     * what swings so much that it changes the motion is not the one that promises most.
     */
    private List<Promise> withPeaks(List<Promise> first, List<Promise> bySeed) {
        List<Promise> peaks =
                IntStream.range(0, bySeed.size())
                        .filter(i -> !isBelow(bySeed, i, i - 1) && !isBelow(bySeed, i, i + 1))
                        .mapToObj(bySeed::get)
                        .filter(peak -> swept.contains(peak.cause()))
                        .filter(
                                peak ->
                                        first.stream()
                                                .anyMatch(p -> p.cause().equals(peak.cause())))
                        .toList();
        Set<Promise> all = new LinkedHashSet<>(first);
        all.addAll(firstOfEach(best(peaks), PEAKS, PEAKS * KEPT));
        return List.copyOf(all);
    }

    /** Whether one promises less than another guess beside it at the same cause. */
    private static boolean isBelow(List<Promise> bySeed, int one, int beside) {
        return beside >= 0
                && beside < bySeed.size()
                && bySeed.get(beside).cause().equals(bySeed.get(one).cause())
                && bySeed.get(beside).score() > bySeed.get(one).score();
    }

    /** What each guess at one cause promises, in their order. */
    private List<Promise> ofEachSeed(List<List<WindowBlock>> blocks) {
        double without = dropOfOwn(gram(blocks, List.of()));
        return seeds.parallelStream().map(seed -> alone(blocks, List.of(seed), without)).toList();
    }

    private static List<Promise> best(List<Promise> promises) {
        return promises.stream()
                .sorted(Comparator.comparingDouble(Promise::score).reversed())
                .toList();
    }

    private Promise alone(List<List<WindowBlock>> blocks, List<Seed> set, double without) {
        Gram gram = gram(blocks, set);
        return promise(gram, IntStream.range(0, gram.columns()).toArray(), set, without);
    }

    /** The products of a set's columns and own ones alone. */
    private Gram gram(List<List<WindowBlock>> blocks, List<Seed> set) {
        return Gram.of(blocks, columns(set), moves.size()).cautious(parameters(set));
    }

    private List<Promise> bestSets(
            List<List<WindowBlock>> blocks, int size, Predicate<Cause> isNew) {
        Gram gram = Gram.of(blocks, moves.size()).cautious(parameters(seeds));
        double without = dropOfOwn(gram);
        List<Promise> best = bestPairs(gram, without, isNew, CONTINUED);
        for (int more = 3; more <= size; more++) {
            List<Promise> continued =
                    best.stream().flatMap(of -> withOneMore(gram, of.set(), without)).toList();
            best = firstOfSets(best(continued), more == size ? KEPT : CONTINUED);
        }
        return best;
    }

    private Stream<Promise> withOneMore(Gram gram, List<Seed> set, double without) {
        return seeds.parallelStream()
                .filter(one -> set.stream().noneMatch(other -> other.cause().equals(one.cause())))
                .map(one -> Stream.concat(set.stream(), Stream.of(one)).toList())
                .map(more -> promise(gram, columns(more), more, without))
                .filter(promise -> promise.score() > 0)
                .toList()
                .stream();
    }

    /** The best of each set of causes, in whatever order they were put together. */
    private static List<Promise> firstOfSets(List<Promise> sorted, int most) {
        Set<Set<Cause>> taken = new HashSet<>();
        return sorted.stream()
                .filter(p -> taken.add(p.set().stream().map(Seed::cause).collect(toSet())))
                .limit(most)
                .toList();
    }

    private List<Promise> bestPairs(
            List<List<WindowBlock>> blocks, Predicate<Cause> isNew, int most) {
        Gram gram = Gram.of(blocks, moves.size()).cautious(parameters(seeds));
        return bestPairs(gram, dropOfOwn(gram), isNew, most);
    }

    private List<Promise> bestPairs(Gram gram, double without, Predicate<Cause> isNew, int most) {
        List<Promise> promises =
                IntStream.range(0, seeds.size())
                        .parallel()
                        .mapToObj(i -> bestPairsOf(gram, i, without, isNew))
                        .flatMap(List::stream)
                        .sorted(Comparator.comparingDouble(Promise::score).reversed())
                        .toList();
        return firstOfEach(promises, 1, most);
    }

    private List<Promise> bestPairsOf(Gram gram, int i, double without, Predicate<Cause> isNew) {
        List<Promise> promises = new ArrayList<>();
        for (int j = i + 1; j < seeds.size(); j++) {
            Cause one = seeds.get(i).cause();
            Cause other = seeds.get(j).cause();
            if (!one.equals(other) && (isNew.test(one) || isNew.test(other))) {
                List<Seed> set = List.of(seeds.get(i), seeds.get(j));
                Promise promise = promise(gram, columns(set), set, without);
                if (promise.score() > 0) {
                    promises.add(promise);
                }
            }
        }
        promises.sort(Comparator.comparingDouble(Promise::score).reversed());
        return List.copyOf(promises.subList(0, Math.min(promises.size(), KEPT)));
    }

    private List<Promise> firstOfEach(List<Promise> sorted, int ofOne, int most) {
        Map<List<Cause>, Integer> taken = new HashMap<>();
        List<Promise> first = new ArrayList<>();
        for (Promise promise : sorted) {
            List<Cause> causes = promise.set().stream().map(Seed::cause).toList();
            if (taken.merge(causes, 1, Integer::sum) <= ofOne && first.size() < most) {
                first.add(promise);
            }
        }
        return first;
    }

    /**
     * What a set promises.
     *
     * @param columns own ones and those of the set, among those of the products
     */
    private Promise promise(Gram gram, int[] columns, List<Seed> set, double without) {
        double[] factors = gram.solve(columns, bounds.of(columns(set)));
        for (int i = 0; i < factors.length; i++) {
            boolean isSeen = Math.abs(factors[i]) * gram.norm(columns[i]) > TRACELESS;
            factors[i] = isSeen ? factors[i] : 0;
        }
        int at = own;
        for (Seed seed : set) {
            int end = at + seed.guess().columns().size();
            if (Arrays.stream(factors, at, end).allMatch(factor -> factor == 0)) {
                return new Promise(set, List.of(), Double.NEGATIVE_INFINITY);
            }
            at = end;
        }
        double price =
                set.stream()
                        .mapToDouble(s -> s.cause().price(outcome.count(), outcome.independent()))
                        .sum();
        double gain = gram.drop(columns, factors) - without;
        return new Promise(set, Arrays.stream(factors).boxed().toList(), gain - price);
    }

    private double dropOfOwn(Gram gram) {
        int[] all = IntStream.range(0, own).toArray();
        return own == 0 ? 0 : gram.drop(all, gram.solve(all, bounds.of(all)));
    }

    /** Own ones, and those of a set. */
    private int[] columns(List<Seed> set) {
        return IntStream.concat(
                        IntStream.range(0, own),
                        set.stream().flatMapToInt(seed -> Arrays.stream(seed.columns())))
                .toArray();
    }
}
