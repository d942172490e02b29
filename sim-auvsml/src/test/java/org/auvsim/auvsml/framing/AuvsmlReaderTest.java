package org.auvsim.auvsml.framing;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.control.PauseSimulatorCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.entity.GetPropulsorListRequest;
import org.auvsim.auvsml.xml.Limits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.LongStream;

class AuvsmlReaderTest {
    private static final MessageCatalogue CATALOGUE =
            MessageCatalogue.load(AuvsmlReaderTest.class.getClassLoader());

    /** Sound roots, and one of each kind of broken ones. */
    private static final String CONVERSATION =
            """
            \uFEFF<?xml version="1.0"?>
            <auvsml request-id="7"><pause-simulator-command/></auvsml><auvxml>
              <!-- twice --><remove-force-command force-name="Schub &amp; \u20ac" world-object-id='1'/>
              <get-propulsor-list-request agent-id="47"/></auvxml>
            <auvsml request-id="8"><pause-simulator/></auvsml>
            <auvsml><get-propulsor-list-request agent-id="x"/></auvsml>
            <auvsml><a></b></auvsml> noise \u20ac <auvsml><cut off
            <auvsml><resume-simulator-command/></auvsml>
            <!DOCTYPE x [<!ENTITY y SYSTEM "file:///etc/passwd">]>
            <auvsml>&y;</auvsml>
            <auvsml><resume-simulator-command/></auvsml>
            <auvsml>\
            """;

    private static final Incoming PAUSE =
            new Incoming.Request(Optional.of("7"), List.of(new PauseSimulatorCommand()));
    private static final Incoming RESUME =
            new Incoming.Request(Optional.empty(), List.of(new ResumeSimulatorCommand()));

    @Test
    void readsAConversationAndGoesOnAfterEachFault() throws IOException {
        List<Incoming> incoming = read(new ByteArrayInputStream(CONVERSATION.getBytes(UTF_8)));

        assertThat(incoming.get(0)).isEqualTo(PAUSE);
        assertThat(incoming.get(1))
                .isEqualTo(
                        new Incoming.Request(
                                Optional.empty(),
                                List.of(
                                        new RemoveForceCommand(1, "Schub & \u20ac"),
                                        new GetPropulsorListRequest(47))));
        assertThat(incoming.subList(2, incoming.size()).stream().map(AuvsmlReaderTest::summary))
                .containsExactly(
                        "8 UNKNOWN_MESSAGE 5:24",
                        "INVALID_VALUE 6:37",
                        "MALFORMED_XML 7:14",
                        "MALFORMED_XML 7:26",
                        "MALFORMED_XML 8:1",
                        "Request",
                        "FORBIDDEN_XML 9:1",
                        "FORBIDDEN_XML 10:11",
                        "Request",
                        "MALFORMED_XML 12:1");
    }

    @Test
    void everySplitOfTheBytesReadsTheSame() throws IOException {
        byte[] bytes = CONVERSATION.getBytes(UTF_8);
        List<Incoming> whole = read(new ByteArrayInputStream(bytes));

        for (int i = 0; i <= bytes.length; i++) {
            InputStream split =
                    new SequenceInputStream(
                            new ByteArrayInputStream(bytes, 0, i),
                            new ByteArrayInputStream(bytes, i, bytes.length - i));
            assertThat(read(split)).as("split at byte %d", i).isEqualTo(whole);
        }
    }

    @Test
    void bytesThatComeOneByOneReadTheSame() throws IOException {
        byte[] bytes = CONVERSATION.getBytes(UTF_8);
        InputStream drops =
                new ByteArrayInputStream(bytes) {
                    @Override
                    public synchronized int read(byte[] into, int offset, int length) {
                        return super.read(into, offset, Math.min(1, length));
                    }
                };

        assertThat(read(drops)).isEqualTo(read(new ByteArrayInputStream(bytes)));
    }

    @Test
    void aMessageOfTwoMebibytesIsSkippedAndTheNextOneRead() throws IOException {
        String large = "<auvsml><remove-force-command force-name=\"" + "x".repeat(2 << 20) + "\"/>";
        List<Incoming> incoming =
                read(large + "</auvsml><auvsml><resume-simulator-command/></auvsml>");

        assertThat(incoming.stream().map(AuvsmlReaderTest::summary))
                .containsExactly("LIMIT_EXCEEDED 1:1", "Request");
        assertThat(incoming.getLast()).isEqualTo(RESUME);
    }

    @Test
    void tenThousandLevelsAreSkippedAndTheNextOneRead() throws IOException {
        List<Incoming> incoming =
                read(
                        "<auvsml>"
                                + "<a>".repeat(10_000)
                                + "</a>".repeat(10_000)
                                + "</auvsml>\n<auvsml><resume-simulator-command/></auvsml>");

        assertThat(incoming.stream().map(AuvsmlReaderTest::summary))
                .containsExactly("LIMIT_EXCEEDED 1:102", "Request");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "<auvsml><pause-simulator-command a='1' a='2'/></auvsml>",
                "<auvsml><pause-simulator-command>&lol;</pause-simulator-command></auvsml>",
                "<auvsml><p:pause-simulator-command/></auvsml>",
                "<auvsml><pause-simulator-command xmlns='urn:x' x='&#0;'/></auvsml>",
                "<auvsml>\u0000</auvsml>",
                "<auvsml 1/>",
                "<auvsml/>",
                "<auvsml>text</auvsml>",
                "<auvsml><pause-simulator-command>text</pause-simulator-command></auvsml>",
                "<auvsml version='2'><pause-simulator-command/></auvsml>",
            })
    void eachOfTheseIsOneFault(String text) throws IOException {
        List<Incoming> incoming = read(text + "<auvsml><resume-simulator-command/></auvsml>");

        assertThat(incoming).hasSize(2);
        assertThat(incoming.getFirst()).isInstanceOf(Incoming.Rejected.class);
        assertThat(incoming.getLast()).isEqualTo(RESUME);
    }

    @Test
    void bytesThatAreNotUtf8AreAFault() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.writeBytes("<auvsml><remove-force-command force-name='".getBytes(UTF_8));
        bytes.writeBytes(new byte[] {(byte) 0xC0, (byte) 0xAF, (byte) 0xFF});
        bytes.writeBytes("' world-object-id='1'/></auvsml>".getBytes(UTF_8));

        assertThat(
                        read(new ByteArrayInputStream(bytes.toByteArray())).stream()
                                .map(AuvsmlReaderTest::code))
                .containsExactly(ErrorCode.MALFORMED_XML);
    }

    @Test
    void aLenientReaderPassesOverWhatItDoesNotKnow() throws IOException {
        String text =
                "<auvsml version='2'><pause-simulator-command"
                        + " since='3'><a/>b</pause-simulator-command>"
                        + "<sonar-message/></auvsml><auvsml><sonar-message/></auvsml>"
                        + "<auvsml><remove-force-command/></auvsml>";
        AuvsmlReader reader =
                new AuvsmlReader(
                        new ByteArrayInputStream(text.getBytes(UTF_8)),
                        RootDecoder.lenient(CATALOGUE, Limits.MESSAGE),
                        Limits.MESSAGE);

        assertThat(reader.next())
                .isEqualTo(
                        new Incoming.Request(
                                Optional.empty(), List.of(new PauseSimulatorCommand())));
        assertThat(reader.next()).isEqualTo(new Incoming.Request(Optional.empty(), List.of()));
        assertThat(code(reader.next())).isEqualTo(ErrorCode.MISSING_VALUE);
    }

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 200);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void noiseIsSkippedAndTheNextMessageRead(long seed) throws IOException {
        byte[] noise = noise(new Random(seed));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.writeBytes(noise);
        bytes.writeBytes(
                "--><auvsml/>]]>?><auvsml><resume-simulator-command/></auvsml>".getBytes(UTF_8));

        assertThat(read(new ByteArrayInputStream(bytes.toByteArray())).getLast()).isEqualTo(RESUME);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void aBrokenConversationEndsWithTheEndAlone(long seed) throws IOException {
        Random random = new Random(seed);
        byte[] bytes = CONVERSATION.getBytes(UTF_8);
        for (int i = 0; i < 1 + seed % 20; i++) {
            bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
        }

        assertThat(read(new ByteArrayInputStream(bytes))).isNotEmpty();
    }

    /** Random bytes, mixed with pieces of markup; what they open, the caller closes. */
    private static byte[] noise(Random random) {
        String[] pieces = {
            "<",
            ">",
            "</",
            "/>",
            "<!--",
            "<![CDATA[",
            "]]>",
            "<?",
            "?>",
            "\"",
            "'",
            "<auvsml",
            "<auvxml>",
            "</auvsml>",
            "&amp;",
            "&#xD800;",
            "<!DOCTYPE",
            "pause-simulator-command",
            " a='",
            "\uFEFF",
            "xml"
        };
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int i = 0; i < 200; i++) {
            if (random.nextBoolean()) {
                bytes.writeBytes(pieces[random.nextInt(pieces.length)].getBytes(UTF_8));
            } else {
                bytes.write(random.nextInt(256));
            }
        }
        return bytes.toByteArray();
    }

    private static List<Incoming> read(String text) throws IOException {
        return read(new ByteArrayInputStream(text.getBytes(UTF_8)));
    }

    private static List<Incoming> read(InputStream in) throws IOException {
        AuvsmlReader reader =
                new AuvsmlReader(in, RootDecoder.strict(CATALOGUE, Limits.MESSAGE), Limits.MESSAGE);
        List<Incoming> incoming = new ArrayList<>();
        Incoming next = reader.next();
        while (!(next instanceof Incoming.End)) {
            incoming.add(next);
            next = reader.next();
        }
        return incoming;
    }

    private static ErrorCode code(Incoming incoming) {
        return ((Incoming.Rejected) incoming).fault().code();
    }

    private static String summary(Incoming incoming) {
        return switch (incoming) {
            case Incoming.Request _ -> "Request";
            case Incoming.Rejected(var id, var fault) ->
                    id.map(i -> i + " ").orElse("")
                            + fault.code()
                            + " "
                            + fault.line()
                            + ":"
                            + fault.column();
            case Incoming.End _ -> "End";
        };
    }
}
