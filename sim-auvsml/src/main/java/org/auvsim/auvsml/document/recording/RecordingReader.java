package org.auvsim.auvsml.document.recording;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.DocumentKind;
import org.auvsim.auvsml.document.MissingFile;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.EntryTypes;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.auvsml.xml.XmlTreeReader;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Reads a recording, compressed or unpacked, entry by entry: a long one needs no more memory than a
 * short one. One that was cut off is read as far as it goes; one that was changed is refused.
 */
public final class RecordingReader implements Closeable {
    private static final String CUT_OFF = "the recording was cut off there";

    private final InputStream in;
    private final String file;
    private final AuvsmlMapper mapper;
    private final XmlTreeReader trees = new XmlTreeReader(Limits.RECORDING);
    private final Blocks blocks;
    private final RootTexts roots;
    private final Recording recording;
    private final Scenario scenario;
    private final EntryOrder order;
    private Reach reach;

    private RecordingReader(InputStream in, String file, AuvsmlMapper mapper)
            throws IOException, DocumentException {
        this.in = in;
        this.file = file;
        this.mapper = mapper;
        this.blocks = blocks(in, file);
        this.roots = new RootTexts(blocks);
        this.recording = readRecording();
        this.reach = new Reach(false, 0, 0, CUT_OFF);
        this.scenario = readScenario();
        this.order = new EntryOrder(scenario.startTime());
        this.reach = new Reach(false, 0, scenario.startTime(), CUT_OFF);
    }

    /**
     * Opens a file and reads its beginning.
     *
     * @param mapper knows the messages and components that the recording may hold
     * @throws DocumentException if the file cannot be read or has no whole scenario
     */
    public static RecordingReader open(Path file, AuvsmlMapper mapper) throws DocumentException {
        try {
            InputStream in = Files.newInputStream(file);
            return of(in, file.toString(), mapper);
        } catch (NoSuchFileException e) {
            throw new DocumentException(MissingFile.sentence(file), e);
        } catch (IOException e) {
            throw new DocumentException(file + " cannot be read: " + e.getMessage(), e);
        }
    }

    /**
     * Reads the beginning of a recording in a stream, which is closed if that fails.
     *
     * @param name what sentences call it
     * @throws DocumentException if it has no whole scenario
     * @throws IOException if the stream cannot be read
     */
    public static RecordingReader of(InputStream in, String name, AuvsmlMapper mapper)
            throws IOException, DocumentException {
        try {
            return new RecordingReader(new BufferedInputStream(in, 1 << 16), name, mapper);
        } catch (IOException | DocumentException | RuntimeException e) {
            in.close();
            throw e;
        }
    }

    private static Blocks blocks(InputStream in, String file)
            throws IOException, DocumentException {
        in.mark(1);
        boolean isGzip = in.read() == (GzipMember.HEADER[0] & 0xff);
        in.reset();
        if (isGzip) {
            return new GzipMembers(in, file);
        }
        in.mark(DocumentKind.BEGINNING);
        if (DocumentKind.of(in.readNBytes(DocumentKind.BEGINNING)) == DocumentKind.SCENARIO) {
            throw new DocumentException(file + " is a scenario, no recording");
        }
        in.reset();
        return new PlainText(in);
    }

    /** What it begins with. */
    public Recording recording() {
        return recording;
    }

    /** The scenario that was run. */
    public Scenario scenario() {
        return scenario;
    }

    /**
     * The next entry; empty at the end, of which {@link #reach()} then tells.
     *
     * @throws DocumentException if the recording is damaged, or states what no recording can
     */
    public Optional<Entry> next() throws DocumentException {
        try {
            Optional<RootText> root = roots.next();
            return root.isEmpty() ? Optional.empty() : entry(root.get());
        } catch (IOException e) {
            throw new DocumentException(file + " cannot be read: " + e.getMessage(), e);
        }
    }

    /** How far it has been read; after its last entry, how far it goes. */
    public Reach reach() {
        return reach;
    }

    private Optional<Entry> entry(RootText root) throws DocumentException {
        try {
            Entry entry = decode(root);
            Optional<String> fault = order.fault(entry);
            if (fault.isPresent()) {
                throw refused(root, ErrorCode.INVALID_VALUE, fault.get());
            }
            reach =
                    entry instanceof RecordingEnded(int _, long step, double time, String reason)
                            ? new Reach(true, step, time, reason)
                            : new Reach(false, entry.step(), entry.timestamp(), CUT_OFF);
            return Optional.of(entry);
        } catch (AuvsmlException e) {
            if (isCutOff(root, e)) {
                return Optional.empty();
            }
            throw refused(root, e);
        }
    }

    private boolean isCutOff(RootText root, AuvsmlException e) {
        return root.isLast()
                && blocks.mayEndAnywhere()
                && !reach.isWhole()
                && e.fault().code() == ErrorCode.MALFORMED_XML
                && trees.isUnfinished(root.bytes());
    }

    private Entry decode(RootText root) throws AuvsmlException, DocumentException {
        XmlTree tree = trees.read(root.bytes());
        String name = tree.root().getName();
        Optional<Class<? extends Entry>> type = EntryTypes.named(name);
        if (type.isEmpty()) {
            throw refused(
                    root,
                    ErrorCode.UNKNOWN_ROOT,
                    "no entry of a recording has the name '%s'; there are %s"
                            .formatted(name, String.join(", ", EntryTypes.names())));
        }
        return mapper.decode(type.get(), tree);
    }

    private Recording readRecording() throws IOException, DocumentException {
        RootText root = first("<recording>");
        try {
            XmlTree tree = trees.read(root.bytes());
            String version = tree.root().getAttributeValue("version");
            boolean isOther =
                    tree.root().getName().equals("recording")
                            && version != null
                            && !version.equals(Integer.toString(Recording.VERSION));
            if (isOther) {
                throw refused(
                        root,
                        ErrorCode.INVALID_VALUE,
                        ("the recording has the format's version %s, but this auvsim reads version"
                                        + " %d; replay it with the auvsim that wrote it")
                                .formatted(version, Recording.VERSION));
            }
            return mapper.decode(Recording.class, tree);
        } catch (AuvsmlException e) {
            throw DocumentKind.of(root.bytes()) == DocumentKind.RECORDING
                    ? refused(root, e)
                    : refused(root, "this is no recording", e);
        }
    }

    private Scenario readScenario() throws IOException, DocumentException {
        RootText root = first("<scenario>");
        try {
            return new ScenarioLoader(mapper, Limits.RECORDING).parse(root.bytes());
        } catch (AuvsmlException e) {
            if (isCutOff(root, e)) {
                throw tooShort("<scenario>");
            }
            throw refused(root, e);
        }
    }

    private RootText first(String element) throws IOException, DocumentException {
        return roots.next().orElseThrow(() -> tooShort(element));
    }

    private DocumentException tooShort(String element) {
        return new DocumentException(
                "%s: a recording begins with <recording> and its <scenario>, but it ends before %s is whole"
                        .formatted(file, element));
    }

    private DocumentException refused(RootText root, ErrorCode code, String problem) {
        return refused(root, new AuvsmlException(new Fault(code, problem, "", 1, 1)));
    }

    private DocumentException refused(RootText root, AuvsmlException e) {
        return refused(root, "root element " + root.number(), e);
    }

    private DocumentException refused(RootText root, String what, AuvsmlException e) {
        Fault fault = e.fault();
        Fault placed =
                new Fault(
                        fault.code(),
                        "%s: %s".formatted(what, fault.problem()),
                        fault.path(),
                        fault.line(),
                        fault.column());
        return new DocumentException(placed.shiftedTo(root.line(), 1).in(file), e);
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
