package org.auvsim.auvsml.document;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.framing.Frame;
import org.auvsim.auvsml.framing.FrameReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.Run;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.Place;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.auvsml.xml.XmlTreeReader;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Finds everything that is wrong with a scenario, with a document of measured runs (what is known
 * of one, a mapping of columns), or with a file of messages one after another: by the schema and by
 * reading it, where of two sentences about one element the reader's counts.
 */
public final class Validation {
    private static final int PACKET = 8192;

    /** Documents of measured runs, by their roots. */
    private static final Map<String, Class<?>> OF_RUNS =
            Map.of("run", Run.class, "column-mapping", ColumnMapping.class);

    private final MessageCatalogue catalogue;
    private final ScenarioLoader scenarios;
    private final SchemaValidator schema;
    private final XmlTreeReader scenarioTrees = new XmlTreeReader(Limits.SCENARIO);
    private final XmlTreeReader messageTrees = new XmlTreeReader(Limits.MESSAGE);

    /** A validation that knows these messages, and the components that their mapper knows. */
    public Validation(MessageCatalogue catalogue) {
        this.catalogue = catalogue;
        this.scenarios = new ScenarioLoader(catalogue.mapper(), Limits.SCENARIO);
        this.schema = new SchemaValidator(Schema.of(catalogue));
    }

    /**
     * All faults of a file, in order of {@link AuvsmlException}; none if it is right.
     *
     * @throws DocumentException if the file cannot be read
     */
    public List<Fault> faults(Path file) throws DocumentException {
        try (InputStream in = Files.newInputStream(file)) {
            return faults(in, ScenarioLoader.folder(file));
        } catch (NoSuchFileException e) {
            throw new DocumentException(MissingFile.sentence(file), e);
        } catch (IOException e) {
            throw new DocumentException(file + " cannot be read: " + e.getMessage(), e);
        }
    }

    /**
     * All faults of a text, in order of {@link AuvsmlException}; none if it is right.
     *
     * @throws IOException if it cannot be read to its end
     */
    public List<Fault> faults(InputStream in) throws IOException {
        return faults(in, Optional.empty());
    }

    private List<Fault> faults(InputStream in, Optional<Path> folder) throws IOException {
        byte[] head = in.readNBytes(Limits.SCENARIO.bytes() + 1);
        String root = scenarioTrees.rootName(head).orElse("");
        if (OF_RUNS.containsKey(root)) {
            AuvsmlMapper mapper = catalogue.mapper();
            return ofDocument(head, tree -> mapper.decode(OF_RUNS.get(root), tree));
        }
        return MessageCatalogue.roots().contains(root)
                ? ofMessages(head, in)
                : ofDocument(head, tree -> scenarios.decode(tree, folder));
    }

    /**
     * What {@link Scenario#notices} has on a file without faults; nothing on any but a scenario.
     *
     * @throws DocumentException if the file cannot be read
     */
    public List<String> notices(Path file) throws DocumentException {
        byte[] text = scenarios.bytes(file);
        String root = scenarioTrees.rootName(text).orElse("");
        if (MessageCatalogue.roots().contains(root) || OF_RUNS.containsKey(root)) {
            return List.of();
        }
        return scenarios.load(file).notices();
    }

    private List<Fault> ofDocument(byte[] text, TreeDecoder decoder) {
        try {
            return of(scenarioTrees.read(text), decoder);
        } catch (AuvsmlException e) {
            return e.faults();
        }
    }

    private List<Fault> ofMessages(byte[] head, InputStream rest) throws IOException {
        FrameReader frames = new FrameReader(Limits.MESSAGE);
        List<Fault> faults = new ArrayList<>();
        byte[] packet = head;
        for (int length = head.length; length >= 0; length = rest.read(packet)) {
            frames.feed(packet, 0, length);
            drain(frames, faults);
            packet = packet.length == PACKET ? packet : new byte[PACKET];
        }
        frames.end();
        drain(frames, faults);
        return faults;
    }

    private void drain(FrameReader frames, List<Fault> faults) {
        for (Optional<Frame> next = frames.next(); next.isPresent(); next = frames.next()) {
            switch (next.get()) {
                case Frame.Broken(Fault fault) -> faults.add(fault);
                case Frame.Root(byte[] text, int line, int column) ->
                        ofRoot(text).stream()
                                .map(fault -> fault.shiftedTo(line, column))
                                .forEach(faults::add);
            }
        }
    }

    private List<Fault> ofRoot(byte[] text) {
        try {
            return of(messageTrees.read(text), catalogue::decode);
        } catch (AuvsmlException e) {
            return e.faults();
        }
    }

    /** Something that reads a tree, or says why it cannot. */
    private interface TreeDecoder {
        Object decode(XmlTree tree) throws AuvsmlException;
    }

    private List<Fault> of(XmlTree tree, TreeDecoder decoder) {
        List<Fault> read = List.of();
        try {
            decoder.decode(tree);
        } catch (AuvsmlException e) {
            read = e.faults();
        }
        TreeSet<Place> elements = new TreeSet<>();
        collect(tree.root(), elements);
        Set<Place> told =
                read.stream()
                        .map(fault -> elements.floor(new Place(fault.line(), fault.column())))
                        .collect(Collectors.toSet());
        Stream<Fault> more =
                schema.faults(tree).stream()
                        .filter(f -> !told.contains(new Place(f.line(), f.column())));
        List<Fault> all = Stream.concat(read.stream(), more).toList();
        return all.isEmpty() ? all : new AuvsmlException(all).faults();
    }

    private static void collect(PlacedElement element, Set<Place> places) {
        places.add(element.place());
        for (int i = 0; i < element.getContentSize(); i++) {
            if (element.getContent(i) instanceof PlacedElement inner) {
                collect(inner, places);
            }
        }
    }
}
