package org.auvsim.diagnosis.cause;

import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.mapping.Names;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.function.Function;
import java.util.stream.Stream;

/** The causes that are known. */
public final class Library {
    /** Those of the trim, a small difference of large forces, which changes from run to run. */
    private static final List<Function<Setting, List<Cause>>> TRIM =
            List.of(WeightCauses::of, InertiaCauses::of);

    private static final List<Function<Setting, List<Cause>>> FLOW =
            List.of(DragCauses::of, CurrentCauses::of);

    private static final List<Function<Setting, List<Cause>>> OTHERS =
            List.of(
                    ThrusterCauses::of,
                    FinCauses::of,
                    HullCauses::of,
                    FrictionCauses::of,
                    PlaceCauses::of,
                    PeriodicCauses::of,
                    OnsetCauses::of,
                    SensorCauses::of);

    private static final int MOST_MEANT = 4;

    /** Fewer letters are in many names. */
    private static final int SHORTEST = 3;

    private Library() {}

    /**
     * Those that make sense for a model's body and what was measured of it: those of this library,
     * effects of scenarios that none of them covers, and those of {@link CauseFamily}s that
     * provider files name in the thread's context. What is common comes first, and is believed
     * before the others where the data cannot tell.
     *
     * @param runs that are to be explained, one or more
     */
    public static List<Cause> of(BelievedModel model, List<MeasuredRun> runs) {
        return of(model, runs, ContextClasses.loader());
    }

    /** The same, with effects and families of causes that another class path has. */
    public static List<Cause> of(BelievedModel model, List<MeasuredRun> runs, ClassLoader loader) {
        Setting setting = Setting.of(model, runs);
        List<Cause> causes = new ArrayList<>();
        Stream.of(setting.floats() ? TRIM : FLOW, setting.floats() ? FLOW : TRIM, OTHERS)
                .flatMap(List::stream)
                .forEach(family -> causes.addAll(family.apply(setting)));
        causes.addAll(EffectCauses.of(setting, loader));
        for (CauseFamily family : ServiceLoader.load(CauseFamily.class, loader)) {
            causes.addAll(family.of(model, runs));
        }
        return List.copyOf(causes);
    }

    /**
     * Those of a library that are named, by their ids, with what they are about as {@link
     * Cause#name} has it, or as {@link Cause#label} does. The fewer they are, the less each must
     * gain to be believed.
     *
     * @throws IllegalArgumentException if a name is that of none
     */
    public static List<Cause> named(List<String> names, List<Cause> library) {
        require(names, library, "can be looked for in these runs");
        List<Cause> some =
                library.stream()
                        .filter(cause -> names.stream().anyMatch(name -> isNamed(cause, name)))
                        .toList();
        return Chosen.of(some, library);
    }

    /**
     * Refuses names that are those of no cause of a model's body, whatever was measured of it: so
     * they are told before runs are read, which takes its time.
     *
     * @throws IllegalArgumentException if a name is that of none
     */
    public static void requireKnown(List<String> names, BelievedModel model) {
        List<Cause> all = of(model, List.of(AllMeasured.of(model)));
        require(names, all, "is known of '%s'".formatted(model.body()));
    }

    private static void require(List<String> names, List<Cause> library, String known) {
        for (String name : names) {
            if (library.stream().noneMatch(cause -> isNamed(cause, name))) {
                throw new IllegalArgumentException(
                        "no cause '%s' %s; %sdocs/causes.md has all, and what each of them needs"
                                .formatted(
                                        name,
                                        known,
                                        Names.meant(meant(name, library))
                                                .map(asked -> asked + " ")
                                                .orElse("")));
            }
        }
    }

    /** Those that hold what was written, as all laws of drag do, or else those that are near. */
    private static List<String> meant(String name, List<Cause> library) {
        List<String> ids = library.stream().map(Cause::id).distinct().toList();
        List<String> ofOthers = ofOthers(name, library);
        if (!ofOthers.isEmpty()) {
            return ofOthers;
        }
        List<String> holding = ids.stream().filter(id -> id.contains(name)).toList();
        return holding.isEmpty() || name.length() < SHORTEST
                ? Names.near(
                        name,
                        Stream.concat(ids.stream(), library.stream().map(Cause::name))
                                .distinct()
                                .toList())
                : holding.subList(0, Math.min(MOST_MEANT, holding.size()));
    }

    /**
     * Where the kind of a cause is written rightly, and what it is about is not: that of a name
     * that is near, or else of all.
     */
    private static List<String> ofOthers(String name, List<Cause> library) {
        Map<String, String> bySubject = new LinkedHashMap<>();
        for (Cause cause : library) {
            if (name.startsWith(cause.id() + " (")) {
                cause.subject().ifPresent(about -> bySubject.put(about, cause.name()));
            }
        }
        String about = name.replaceFirst("^[^(]*\\(", "").replaceFirst("\\)$", "");
        List<String> near = Names.near(about, bySubject.keySet());
        return near.isEmpty()
                ? List.copyOf(bySubject.values())
                : near.stream().map(bySubject::get).toList();
    }

    private static boolean isNamed(Cause cause, String name) {
        return List.of(cause.id(), cause.name(), cause.label()).contains(name);
    }
}
