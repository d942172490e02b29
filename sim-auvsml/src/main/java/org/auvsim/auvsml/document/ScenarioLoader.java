package org.auvsim.auvsml.document;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.auvsml.xml.XmlTreeReader;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** Reads scenarios: root element {@code <scenario>}, in a file or as bytes. */
public final class ScenarioLoader {
    /** So many faults of a file are told, a line each. */
    private static final int MOST_LINES = 20;

    private final AuvsmlMapper mapper;
    private final Limits limits;
    private final XmlTreeReader trees;

    /** A loader for scenarios of at most {@code limits}. */
    public ScenarioLoader(AuvsmlMapper mapper, Limits limits) {
        this.mapper = mapper;
        this.limits = limits;
        this.trees = new XmlTreeReader(limits);
    }

    /** A loader that knows what {@code loader}'s provider files name, with the usual limits. */
    public static ScenarioLoader load(ClassLoader loader) {
        return new ScenarioLoader(AuvsmlMapper.load(loader), Limits.SCENARIO);
    }

    /**
     * The scenario in a file.
     *
     * @throws DocumentException if there is no such file, or anything is wrong with it
     */
    public Scenario load(Path file) throws DocumentException {
        try {
            return decode(trees.read(bytes(file)), folder(file));
        } catch (AuvsmlException e) {
            throw new DocumentException(lines(file, e.faults()), e);
        }
    }

    private static String lines(Path file, List<Fault> faults) {
        String lines =
                faults.stream()
                        .limit(MOST_LINES)
                        .map(fault -> fault.in(file))
                        .collect(Collectors.joining("\n"));
        int more = faults.size() - MOST_LINES;
        return more > 0 ? lines + "\n%s: %d faults more".formatted(file, more) : lines;
    }

    /** Where the files are that a scenario in this one names. */
    static Optional<Path> folder(Path file) {
        return Optional.ofNullable(file.toAbsolutePath().getParent());
    }

    /** A file's bytes, one more than the limit at most. */
    byte[] bytes(Path file) throws DocumentException {
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = in.readNBytes(limits.bytes() + 1);
            if (DocumentKind.of(bytes) == DocumentKind.RECORDING) {
                throw new DocumentException(
                        file + " is a recording; replay it with 'auvsim replay'");
            }
            return bytes;
        } catch (NoSuchFileException e) {
            throw new DocumentException(MissingFile.sentence(file), e);
        } catch (IOException e) {
            throw new DocumentException(
                    Files.isDirectory(file)
                            ? file + " is a folder; expected a file, name one in it"
                            : file + " cannot be read: " + e.getMessage(),
                    e);
        }
    }

    /**
     * The scenario in a text, which cannot name other files.
     *
     * @throws AuvsmlException with every fault that was found
     */
    public Scenario parse(byte[] xml) throws AuvsmlException {
        return decode(trees.read(xml), Optional.empty());
    }

    /** What the tree states, with what is in the files of the folder that it names. */
    Scenario decode(XmlTree tree, Optional<Path> folder) throws AuvsmlException {
        List<Fault> faults = new ArrayList<>();
        Optional<Scenario> scenario =
                read(tree, faults)
                        .map(
                                read ->
                                        folder.map(f -> GridFiles.in(read, f, tree, faults))
                                                .orElse(read));
        faults.addAll(Twins.in(tree));
        if (scenario.isPresent() && faults.isEmpty()) {
            faults.addAll(WorldFaults.in(scenario.get(), tree));
        } else {
            faults.addAll(WorldFaults.inSoundPart(tree, List.copyOf(faults), mapper));
        }
        if (faults.isEmpty()) {
            return scenario.orElseThrow();
        }
        throw new AuvsmlException(faults);
    }

    private Optional<Scenario> read(XmlTree tree, List<Fault> faults) {
        try {
            return Optional.of(mapper.decode(Scenario.class, tree));
        } catch (AuvsmlException e) {
            faults.addAll(e.faults());
            return Optional.empty();
        }
    }
}
