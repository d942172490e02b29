package org.auvsim.auvsml.framing;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.xml.Limits;

import java.util.ArrayDeque;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;

/**
 * Cuts a stream of bytes into root elements, however the bytes are split into packets.
 *
 * <p>It knows just enough of XML to see where a root ends. What breaks that, or the limits, is
 * reported once and skipped up to the next {@code <auvsml} or {@code <auvxml}; so is what stands
 * between roots and is neither white space, comment nor declaration. It keeps at most one message
 * of the largest size. Not for several threads at once.
 */
public final class FrameReader {
    private enum Mode {
        /** Between roots. */
        BETWEEN,
        /** In a root, which is kept. */
        INSIDE,
        /** After a fault: all is passed over but the start of a root. */
        SKIPPING
    }

    private final Limits limits;
    private final Markup markup = new Markup();
    private final Position position = new Position();
    private final FrameBuffer kept = new FrameBuffer();
    private final Queue<Frame> found = new ArrayDeque<>();
    private Mode mode = Mode.BETWEEN;
    private int depth;
    private long tagOffset;
    private int tagLine = 1;
    private int tagColumn = 1;
    private int rootLine = 1;
    private int rootColumn = 1;

    /** A reader at the start of a stream. */
    public FrameReader(Limits limits) {
        this.limits = limits;
    }

    /** Takes the stream's next bytes; what they complete is in {@link #next()}. */
    public void feed(byte[] bytes, int offset, int length) {
        int end = offset + length;
        int i = offset;
        while (i < end) {
            i += mode == Mode.INSIDE ? keepPlainRun(bytes, i, end) : 0;
            if (i < end) {
                accept(bytes[i]);
                position.pass(bytes[i]);
                i++;
            }
        }
    }

    private int keepPlainRun(byte[] bytes, int from, int end) {
        int room = limits.bytes() - kept.size();
        int run = markup.plainRun(bytes, from, Math.min(end, from + room));
        kept.add(bytes, from, run);
        position.passPlain(run);
        return run;
    }

    /** Says that the stream is over: a root that is not complete will not be. */
    public void end() {
        if (mode == Mode.INSIDE) {
            reportRoot(
                    ErrorCode.MALFORMED_XML,
                    "expected the end of this root element, but the stream ended");
        } else if (mode == Mode.BETWEEN && markup.isOpen()) {
            faultAtTag(ErrorCode.MALFORMED_XML, "something without end");
        }
        skip();
    }

    /** What was found next; empty until more bytes are fed. */
    public Optional<Frame> next() {
        return Optional.ofNullable(found.poll());
    }

    private void accept(byte b) {
        Markup.Event event = markup.accept(b);
        if (event == Markup.Event.TAG_BEGINS || event == Markup.Event.MISPLACED_TAG_BEGINS) {
            tagOffset = position.offset();
            tagLine = position.line();
            tagColumn = position.column();
        }
        boolean namesRoot = event == Markup.Event.START_TAG_NAMED && markup.isRootName();
        if (namesRoot) {
            if (mode == Mode.INSIDE) {
                reportRoot(
                        ErrorCode.MALFORMED_XML,
                        "expected the end of this root element, but another one begins");
            }
            beginRoot(b);
        } else if (mode == Mode.BETWEEN) {
            between(event);
        } else if (mode == Mode.INSIDE) {
            inside(event, b);
        }
    }

    private void between(Markup.Event event) {
        switch (event) {
            case START_TAG_NAMED -> faultAtTag(ErrorCode.UNKNOWN_ROOT, "<" + markup.name() + ">");
            case END_TAG_ENDS ->
                    faultAtTag(ErrorCode.MALFORMED_XML, "the end tag </" + markup.name() + ">");
            case INSTRUCTION_ENDS -> checkEncoding();
            case FORBIDDEN -> faultAtTag(ErrorCode.FORBIDDEN_XML, "a DOCTYPE or declaration");
            case TEXT, MISPLACED_TAG_BEGINS ->
                    fault(
                            ErrorCode.MALFORMED_XML,
                            "expected <auvsml>, but found something else",
                            position.line(),
                            position.column());
            default -> {
                if (markup.isOpen() && position.offset() - tagOffset >= limits.bytes()) {
                    faultAtTag(ErrorCode.LIMIT_EXCEEDED, "a comment or instruction without end");
                }
            }
        }
    }

    private void inside(Markup.Event event, byte b) {
        if (kept.size() == limits.bytes()) {
            reportRoot(
                    ErrorCode.LIMIT_EXCEEDED,
                    "expected at most %d bytes in a root element, but this one has more"
                            .formatted(limits.bytes()));
            skip();
            return;
        }
        kept.add(b);
        switch (event) {
            case START_TAG_NAMED -> deeper();
            case ATTRIBUTE_BEGINS -> countAttributes();
            case EMPTY_TAG_ENDS, END_TAG_ENDS -> tagEnds();
            case FORBIDDEN ->
                    fault(
                            ErrorCode.FORBIDDEN_XML,
                            "expected elements, but found a DOCTYPE or declaration",
                            tagLine,
                            tagColumn);
            case MISPLACED_TAG_BEGINS ->
                    fault(
                            ErrorCode.MALFORMED_XML,
                            "expected the end of the tag or value before, but found '<'",
                            tagLine,
                            tagColumn);
            default -> {
                // what stands inside is the parser's
            }
        }
    }

    private void tagEnds() {
        depth--;
        if (markup.isRootName()) {
            found.add(new Frame.Root(kept.take(), rootLine, rootColumn));
            mode = Mode.BETWEEN;
        }
    }

    /** The root's name is known; {@code b} is the byte after it. */
    private void beginRoot(byte b) {
        kept.clear();
        kept.add((byte) '<');
        for (char c : markup.name().toCharArray()) {
            kept.add((byte) c);
        }
        kept.add(b);
        rootLine = tagLine;
        rootColumn = tagColumn;
        depth = 1;
        mode = Mode.INSIDE;
    }

    private void deeper() {
        depth++;
        if (depth > limits.depth()) {
            fault(
                    ErrorCode.LIMIT_EXCEEDED,
                    "expected elements nested at most %d deep, but <%s> is deeper"
                            .formatted(limits.depth(), markup.name()),
                    tagLine,
                    tagColumn);
        }
    }

    private void countAttributes() {
        if (markup.attributes() > limits.attributes()) {
            fault(
                    ErrorCode.LIMIT_EXCEEDED,
                    "expected at most %d attributes in an element, but <%s> has more"
                            .formatted(limits.attributes(), markup.name()),
                    tagLine,
                    tagColumn);
        }
    }

    private void checkEncoding() {
        String text = markup.name().toLowerCase(Locale.ROOT);
        if (text.startsWith("xml ")
                && text.contains("encoding")
                && !text.contains("utf-8")
                && !text.contains("us-ascii")) {
            fault(
                    ErrorCode.FORBIDDEN_XML,
                    "expected the encoding UTF-8, but another one is declared",
                    tagLine,
                    tagColumn);
        }
    }

    private void faultAtTag(ErrorCode code, String found) {
        fault(code, "expected <auvsml>, but found " + found, tagLine, tagColumn);
    }

    private void fault(ErrorCode code, String problem, int line, int column) {
        report(code, problem, line, column);
        skip();
    }

    private void reportRoot(ErrorCode code, String problem) {
        report(code, problem, rootLine, rootColumn);
    }

    private void report(ErrorCode code, String problem, int line, int column) {
        found.add(new Frame.Broken(new Fault(code, problem, "", line, column)));
    }

    private void skip() {
        kept.clear();
        mode = Mode.SKIPPING;
        markup.search();
    }
}
