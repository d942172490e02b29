package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Measured positions beside what the model does. If some of them are told in a unit that is off by
 * 1000, the model moves as they do once they are told in the right one, and not before. What counts
 * is how a path bends, as that is what forces do, in parts of the run that begin as measured. A
 * model that lacks something does not bend as measured in any unit: for that its forces would have
 * to be wrong by just 1000.
 */
final class ModelUnits {
    private static final double FACTOR = 1000;

    /** Axes of which the unit may be wrong together. */
    private static final List<Set<Integer>> TOGETHER =
            List.of(Set.of(0, 1, 2), Set.of(0, 1), Set.of(2), Set.of(0), Set.of(1));

    /** The run is looked at as a whole, and in such shares of it. */
    private static final int[] PARTS = {1, 3, 9};

    private static final int MOST_OF_THEM = 3;

    /**
     * A misfit of this share of what forces do is little; for the model may lack something, too. As
     * told it then says that the units are right.
     */
    private static final double FITS = 0.5;

    /** A misfit of this share, and so many times that in another unit, is that of another unit. */
    private static final double FITS_NOT = 0.7;

    private static final double BETTER = 5;

    /** Only where the ways differ by this factor another unit is tried. */
    private static final double FAR = 30;

    /** Ways that differ by less are of the same unit, whatever the model lacks. */
    private static final double AS_FAR = 5;

    /** An axis tells something where forces do such a share (of squares) of what they do at all. */
    private static final double MATTERS = 0.0025;

    /** Paths that bend so much alike (correlation) bend for the same reason. */
    private static final double ALIKE = 0.85;

    private static final double HARDLY_ALIKE = 0.5;

    /** So many times another force than the model's is still to be expected of a wrong model. */
    private static final double TIMES = 4;

    private final BelievedModel model;
    private final MeasuredRun run;
    private final Set<Integer> measured = new HashSet<>();

    ModelUnits(BelievedModel model, MeasuredRun run) {
        this.model = model;
        this.run = run;
        IntStream.range(0, 3)
                .filter(axis -> run.measures(Channel.POSITION, axis))
                .forEach(measured::add);
    }

    /**
     * That positions along axes would have to be told in another unit.
     *
     * @param factor by which they fit the model
     */
    record Suspicion(List<Integer> axes, double factor) {}

    /** What a hypothesis makes of the parts. */
    private static final class Account {
        private final Suspicion of;
        private boolean isRefuted;
        private boolean isBorneOut;
        private double misfit;
        private final Set<Integer> axes = new HashSet<>();

        Account(Suspicion of) {
            this.of = of;
        }

        double misfit() {
            return misfit;
        }
    }

    /** What is suspected, if anything is. */
    Optional<Suspicion> suspicion() {
        List<Account> accounts = accounts();
        for (int parts : PARTS) {
            List<UnitTrial> trials = trials(parts, accounts);
            accounts.forEach(account -> judge(account, trials));
            accounts.removeIf(account -> account.isRefuted);
        }
        Optional<Account> best = Optional.empty();
        for (Account account : accounts) {
            boolean isBetter = best.isEmpty() || account.misfit() < best.get().misfit() / 2;
            if (account.isBorneOut && !account.axes.isEmpty() && isBetter) {
                best = Optional.of(account);
            }
        }
        return best.map(a -> new Suspicion(a.axes.stream().sorted().toList(), a.of.factor()));
    }

    private List<Account> accounts() {
        Set<Set<Integer>> sets = new LinkedHashSet<>();
        for (Set<Integer> together : TOGETHER) {
            Set<Integer> axes = new HashSet<>(together);
            axes.retainAll(measured);
            if (!axes.isEmpty()) {
                sets.add(axes);
            }
        }
        List<Account> accounts = new ArrayList<>();
        for (Set<Integer> axes : sets) {
            accounts.add(new Account(new Suspicion(List.copyOf(axes), 1 / FACTOR)));
            accounts.add(new Account(new Suspicion(List.copyOf(axes), FACTOR)));
        }
        return accounts;
    }

    private List<UnitTrial> trials(int parts, List<Account> accounts) {
        List<UnitTrial> trials = new ArrayList<>();
        if (accounts.isEmpty() || run.size() / parts < UnitTrial.FEWEST) {
            return trials;
        }
        int count = Math.min(parts, MOST_OF_THEM);
        for (int i = 0; i < count; i++) {
            int part = count == 1 ? 0 : i * (parts - 1) / (count - 1);
            int from = (int) ((long) part * run.size() / parts);
            int to = (int) ((long) (part + 1) * run.size() / parts) - 1;
            UnitTrial trial = UnitTrial.of(model, run, from, to);
            accounts.forEach(a -> a.isRefuted |= isAsFar(trial.farther(a.of.axes())));
            List<Suspicion> worthwhile =
                    accounts.stream()
                            .map(account -> account.of)
                            .filter(of -> isPossible(of, trial.farther(of.axes())))
                            .toList();
            if (!worthwhile.isEmpty()) {
                trials.add(trial.of(worthwhile));
            }
        }
        return trials;
    }

    /** Whether a way that is so many times that of the model from rest can be in another unit. */
    private static boolean isPossible(Suspicion of, double farther) {
        return of.factor() < 1 ? farther > FAR : farther < 1 / FAR;
    }

    /** Whether such a way speaks for the unit as told: in another one it would be far too short. */
    private static boolean isAsFar(double farther) {
        return farther > 1 / AS_FAR && farther < AS_FAR;
    }

    private void judge(Account account, List<UnitTrial> trials) {
        List<UnitTrial> fitting = new ArrayList<>();
        int telling = 0;
        for (UnitTrial trial : trials) {
            if (trial.has(account.of)) {
                account.isRefuted |= fitsAsTold(trial, account.of.axes());
                telling += trial.isNoise(account.of.axes()) ? 0 : 1;
                if (fits(trial, account.of)) {
                    fitting.add(trial);
                }
            }
        }
        account.isRefuted |= telling > 1 && 2 * fitting.size() < telling;
        if (!fitting.isEmpty() && !account.isBorneOut) {
            account.isBorneOut = true;
            account.misfit =
                    fitting.stream()
                            .mapToDouble(trial -> trial.misfit(account.of, measured))
                            .average()
                            .orElseThrow();
            fitting.forEach(trial -> account.axes.addAll(telling(account.of, trial)));
        }
    }

    private static boolean fitsAsTold(UnitTrial trial, List<Integer> axes) {
        return trial.misfit(UnitTrial.AS_TOLD, axes) <= FITS
                || trial.areAlike(UnitTrial.AS_TOLD, axes, HARDLY_ALIKE, FAR);
    }

    /** By how it bends; or by that it does not, where forces in balance leave it straight. */
    private static boolean fits(UnitTrial trial, Suspicion of) {
        double otherwise = trial.misfit(of, of.axes());
        double asTold = trial.misfit(UnitTrial.AS_TOLD, of.axes());
        boolean isFar = asTold >= Math.max(FITS_NOT, BETTER * otherwise);
        return !trial.isNoise(of.axes())
                && (trial.areAlike(of, of.axes(), ALIKE, TIMES) || (otherwise <= FITS && isFar));
    }

    /** Those of a hypothesis' axes along which the model bends, too. */
    private static List<Integer> telling(Suspicion of, UnitTrial trial) {
        double most = of.axes().stream().mapToDouble(a -> trial.forces(of, a)).max().orElse(0);
        return of.axes().stream()
                .filter(axis -> trial.forces(of, axis) > MATTERS * most)
                .filter(axis -> !trial.isNoise(List.of(axis)))
                .filter(axis -> !fitsAsTold(trial, List.of(axis)))
                .toList();
    }
}
