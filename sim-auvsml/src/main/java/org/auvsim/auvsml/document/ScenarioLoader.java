package org.auvsim.auvsml.document;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.auvsml.xml.XmlTreeReader;
import org.auvsim.core.world.WorldException;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Reads scenarios: root element {@code <scenario>}, in a file or as bytes. */
public final class ScenarioLoader {
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
            return parse(bytes(file));
        } catch (AuvsmlException e) {
            throw new DocumentException(file + ", " + e.getMessage(), e);
        }
    }

    /** A file's bytes, one more than the limit at most. */
    byte[] bytes(Path file) throws DocumentException {
        try (InputStream in = Files.newInputStream(file)) {
            return in.readNBytes(limits.bytes() + 1);
        } catch (NoSuchFileException e) {
            throw new DocumentException(file + ": there is no such file", e);
        } catch (IOException e) {
            throw new DocumentException(file + " cannot be read: " + e.getMessage(), e);
        }
    }

    /**
     * The scenario in a text.
     *
     * @throws AuvsmlException with every fault that was found
     */
    public Scenario parse(byte[] xml) throws AuvsmlException {
        return decode(trees.read(xml));
    }

    Scenario decode(XmlTree tree) throws AuvsmlException {
        List<Fault> faults = new ArrayList<>(Twins.in(tree));
        try {
            Scenario scenario = mapper.decode(Scenario.class, tree);
            if (faults.isEmpty()) {
                requireWorld(scenario, tree);
                return scenario;
            }
        } catch (AuvsmlException e) {
            faults.addAll(0, e.faults());
        }
        throw new AuvsmlException(faults);
    }

    /** What only the finished world can tell has the scenario's own place. */
    private static void requireWorld(Scenario scenario, XmlTree tree) throws AuvsmlException {
        try {
            scenario.world();
        } catch (WorldException | IllegalArgumentException e) {
            throw new AuvsmlException(
                    new Fault(
                            ErrorCode.INVALID_VALUE,
                            String.valueOf(e.getMessage()),
                            tree.root().getName(),
                            tree.root().place().line(),
                            tree.root().place().column()));
        }
    }
}
