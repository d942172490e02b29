package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.RunRole;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Split;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * The runs of several files, told apart into those to fit and those to judge.
 *
 * @param fit what causes are looked for in
 * @param heldOut what judges them
 * @param reference that are known to be sound, beside them
 * @param notices what was done to the data, and what looks wrong with it
 * @param doubt whether some of them doubt that the numbers are what they are taken for
 * @param settled what is left of some of them where a model explains the runs
 */
public record RunFiles(
        List<MeasuredRun> fit,
        List<MeasuredRun> heldOut,
        List<MeasuredRun> reference,
        List<String> notices,
        Doubt doubt,
        Map<String, String> settled) {
    /** The lists and the map cannot be changed. */
    public RunFiles {
        fit = List.copyOf(fit);
        heldOut = List.copyOf(heldOut);
        reference = List.copyOf(reference);
        notices = List.copyOf(notices);
        settled = Map.copyOf(settled);
    }

    /**
     * Reads files. A run whose document gives it the role to be held out is so, also among those to
     * fit; without any to hold out, runs or parts of the only one are.
     *
     * @param fit at least one
     * @throws DocumentException naming file, row and column of what cannot be used
     */
    public static RunFiles read(RunReader reader, List<Path> fit, List<Path> heldOut)
            throws DocumentException {
        return read(reader, fit, heldOut, List.of());
    }

    /**
     * The same beside reference runs, which are known to be sound and count as a whole.
     *
     * @throws DocumentException naming file, row and column of what cannot be used
     */
    public static RunFiles read(
            RunReader reader, List<Path> fit, List<Path> heldOut, List<Path> reference)
            throws DocumentException {
        requireDifferent(fit, heldOut);
        requireOthers(reference, fit, heldOut);
        List<MeasuredRun> toFit = new ArrayList<>();
        List<MeasuredRun> toJudge = new ArrayList<>();
        List<String> notices = new ArrayList<>(reader.notices());
        List<Path> all = new ArrayList<>(fit);
        all.addAll(heldOut);
        int asked = all.size();
        all.addAll(reference);
        reader.requireRenamed(all);
        List<MeasuredRun> sound = new ArrayList<>();
        List<RunFile> read = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            RunReader of = i < asked ? reader : reader.ofWholeRuns();
            RunFile file = of.read(all.get(i), name(all, i));
            requireNew(file, read);
            read.add(file);
            notices.addAll(file.notices());
            if (i >= asked) {
                sound.addAll(file.runs());
            } else {
                boolean isHeldOut = i >= fit.size() || saysHeldOut(file, notices);
                (isHeldOut ? toJudge : toFit).addAll(file.runs());
            }
        }
        ToldAlike.require(read);
        OddUnits.require(read);
        Doubt doubt = read.stream().map(RunFile::doubt).reduce(Doubt.NONE, Doubt::and);
        Map<String, String> settled = new LinkedHashMap<>();
        read.forEach(file -> settled.putAll(file.settled()));
        RunFiles files =
                new RunFiles(toFit, toJudge, sound, notices, doubt.and(ofAxes(read)), settled);
        return files.told(all.subList(0, asked));
    }

    /** Axes are those of all files; a few may look otherwise by what the model lacks in them. */
    private static Doubt ofAxes(List<RunFile> files) {
        long turned = files.stream().filter(RunFile::looksTurned).count();
        if (turned == 0) {
            return Doubt.NONE;
        }
        return 2 * turned > files.size() ? Doubt.LASTING : Doubt.UNTIL_EXPLAINED;
    }

    /**
     * The same, the runs to fit cut into equal parts of about a time (s), each with a start of its
     * own: so far ahead a model is then asked to predict, and no further. Parts have 16 samples at
     * least.
     *
     * @throws IllegalArgumentException if the time is not above 0
     */
    public RunFiles inParts(double seconds) {
        if (!(seconds > 0)) {
            throw new IllegalArgumentException(
                    "parts of runs must be longer than 0 s, but are to be of %s s"
                            .formatted(seconds));
        }
        List<MeasuredRun> parts = new ArrayList<>();
        List<String> told = new ArrayList<>(notices);
        for (MeasuredRun run : fit) {
            long most = Math.max(1, run.size() / MeasuredRun.FEWEST);
            int count = (int) Math.clamp(Math.round(run.duration() / seconds), 1, most);
            parts.addAll(run.parts(count));
            told.add(
                    "%s: fitted in %d parts of %s s, each with a start of its own"
                            .formatted(run.name(), count, Figures.shown(run.duration() / count)));
        }
        return new RunFiles(parts, heldOut, reference, told, doubt, settled);
    }

    /**
     * What is to be said of the data after a verdict: of a doubt that it settles, how.
     *
     * @param errors of the channels, in their units
     */
    public List<String> noticesAfter(Verdict verdict, Map<Channel, Double> errors) {
        boolean isExplained = verdict == Verdict.EXPLAINED || verdict == Verdict.NONE;
        return !isExplained || doubt.isOpen(verdict, errors)
                ? notices
                : notices.stream().map(said -> settled.getOrDefault(said, said)).toList();
    }

    /** The same, some of the runs held out if none are. */
    private RunFiles told(List<Path> all) throws DocumentException {
        if (fit.isEmpty()) {
            throw new DocumentException(
                    "all runs of %s are to be held out; expected one to fit at least"
                            .formatted(all));
        }
        if (!heldOut.isEmpty()) {
            return this;
        }
        try {
            Split split = Split.of(fit);
            List<String> more = new ArrayList<>(notices);
            more.add(split.notice());
            return new RunFiles(split.fit(), split.heldOut(), reference, more, doubt, settled);
        } catch (IllegalArgumentException e) {
            throw new DocumentException(all.getFirst() + ": " + e.getMessage(), e);
        }
    }

    private static boolean saysHeldOut(RunFile file, List<String> notices) {
        boolean says = file.role().filter(RunRole.HOLDOUT::equals).isPresent();
        if (says) {
            notices.add(
                    "%s: the document beside it says that it is held out"
                            .formatted(file.runs().getFirst().name()));
        }
        return says;
    }

    /** A file's name, with a number if one before it has the same. */
    private static String name(List<Path> files, int i) {
        String name = RunReader.nameOf(files.get(i));
        long before =
                files.subList(0, i).stream()
                        .filter(other -> RunReader.nameOf(other).equals(name))
                        .count();
        return before == 0 ? name : name + "_" + (before + 1);
    }

    private static void requireDifferent(List<Path> fit, List<Path> heldOut)
            throws DocumentException {
        for (int i = 0; i < fit.size(); i++) {
            for (Path other : fit.subList(0, i)) {
                if (isSame(fit.get(i), other)) {
                    throw new DocumentException(
                            "%s is given twice to fit; give each run once".formatted(other));
                }
            }
            for (Path other : heldOut) {
                if (isSame(fit.get(i), other)) {
                    throw new DocumentException(
                            "%s is given to fit and to hold out; what is fitted cannot judge: give another run"
                                    .formatted(other));
                }
            }
        }
    }

    private static void requireOthers(List<Path> reference, List<Path> fit, List<Path> heldOut)
            throws DocumentException {
        for (int i = 0; i < reference.size(); i++) {
            Path file = reference.get(i);
            if (reference.subList(0, i).stream().anyMatch(other -> isSame(file, other))) {
                throw new DocumentException(
                        "%s is given twice as a reference; give each run once".formatted(file));
            }
            if (Stream.concat(fit.stream(), heldOut.stream()).anyMatch(o -> isSame(file, o))) {
                throw new DocumentException(
                        "%s is given as a reference and to be diagnosed; no run is its own measure: give another one"
                                .formatted(file));
            }
        }
    }

    private static boolean isSame(Path one, Path other) {
        try {
            return Files.isSameFile(one, other);
        } catch (IOException _) {
            return one.toAbsolutePath().normalize().equals(other.toAbsolutePath().normalize());
        }
    }

    private static void requireNew(RunFile file, List<RunFile> before) throws DocumentException {
        for (int i = 0; i < file.runs().size(); i++) {
            for (RunFile other : before) {
                for (int j = 0; j < other.runs().size(); j++) {
                    if (areCopies(file.runs().get(i), other.runs().get(j))) {
                        throw copy(file.sources().get(i), other.sources().get(j));
                    }
                }
            }
            for (int j = 0; j < i; j++) {
                if (areCopies(file.runs().get(i), file.runs().get(j))) {
                    throw copy(file.sources().get(i), file.sources().get(j));
                }
            }
        }
    }

    private static DocumentException copy(Source one, Source other) {
        String has = one.isTable() ? one.span() + "have" : "it has";
        String those = other.isTable() ? other.span() + "of " : "";
        return new DocumentException(
                one.says(
                        one.measured(),
                        "%s the same numbers as %s%s; a copy adds no information and cannot judge: leave one of them out"
                                .formatted(has, those, other.file())));
    }

    /** Of a reference all counts, of others perhaps a stretch alone. */
    private static boolean areCopies(MeasuredRun one, MeasuredRun other) {
        return isSame(one, other) || isSame(one.whole(), other.whole());
    }

    private static boolean isSame(MeasuredRun one, MeasuredRun other) {
        boolean same = one.size() == other.size();
        for (int k = 0; same && k < one.size(); k++) {
            same = one.orientation(k).equals(other.orientation(k));
            for (Channel channel : Channel.values()) {
                for (int axis = 0; axis < 3; axis++) {
                    same &=
                            Double.compare(
                                            one.value(channel, k, axis),
                                            other.value(channel, k, axis))
                                    == 0;
                }
            }
        }
        return same;
    }
}
