package org.auvsim.auvsml.document.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.recording.ClientCame;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.auvsim.auvsml.recording.StateHash;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

class RecordingReaderTest {
    private static final int STEPS = 12;

    private final List<Entry> entries = Recordings.entries(STEPS, new Random(1));

    @Test
    void whatIsWrittenIsReadAsWhatItWas() throws Exception {
        RecordingReader reader = Recordings.reader(Recordings.written(entries));

        assertThat(reader.recording()).isEqualTo(Recordings.BEGINNING);
        assertThat(reader.scenario()).isEqualTo(Recordings.scenario());
        assertThat(Recordings.rest(reader)).isEqualTo(entries);
        assertThat(reader.reach())
                .isEqualTo(new Reach(true, STEPS, 3 + 0.05 * STEPS, "the simulation has ended"));
    }

    /** A message of a user's own. */
    record DropAnchor(double depth) implements Message {}

    @Test
    void messagesOfAUsersOwnAreReadAsTheyWere() throws Exception {
        AuvsmlMapper mapper =
                AuvsmlMapper.builder(getClass().getClassLoader())
                        .register(Message.class, DropAnchor.class)
                        .build();
        Entry sent =
                new ClientSent(
                        0, 0, 0, false, 3, 1, Optional.empty(), List.of(new DropAnchor(12.5)));
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        try (RecordingWriter writer = new RecordingWriter(file, mapper)) {
            writer.begin(Recordings.BEGINNING, Recordings.scenario());
            writer.write(sent);
        }

        try (RecordingReader reader =
                RecordingReader.of(
                        new ByteArrayInputStream(file.toByteArray()), "run.auvsml.gz", mapper)) {
            assertThat(reader.next()).contains(sent);
        }
        assertThatThrownBy(() -> Recordings.rest(Recordings.reader(file.toByteArray())))
                .hasMessageContaining("unknown element 'drop-anchor'");
    }

    @Test
    void unpackedItIsReadJustSo() throws Exception {
        RecordingReader reader = Recordings.reader(unpacked(Recordings.written(entries)));

        assertThat(Recordings.rest(reader)).isEqualTo(entries);
        assertThat(reader.reach().isWhole()).isTrue();
    }

    @Test
    void cutOffAnywhereItIsReadUpToTheLastWholeMember() throws Exception {
        byte[] file = Recordings.written(entries);
        int beginning = Recordings.written(List.of()).length;
        int longest = 0;
        for (int length = beginning; length < file.length; length += 5) {
            RecordingReader reader = Recordings.reader(Arrays.copyOf(file, length));
            List<Entry> read = Recordings.rest(reader);

            assertThat(read).isEqualTo(entries.subList(0, read.size()));
            assertThat(read.size()).isBetween(longest, longest + 3);
            assertThat(reader.reach().isWhole()).isFalse();
            assertThat(reader.reach().reason()).contains("cut off");
            longest = read.size();
        }
        assertThat(longest).isGreaterThan(entries.size() - 7);
    }

    @Test
    void unpackedAndCutOffAnywhereItIsReadUpToTheLastWholeEntry() throws Exception {
        byte[] text = unpacked(Recordings.written(entries));
        int beginning = unpacked(Recordings.written(List.of())).length;
        for (int length = beginning; length < text.length - 1; length += 11) {
            RecordingReader reader = Recordings.reader(Arrays.copyOf(text, length));
            List<Entry> read = Recordings.rest(reader);

            assertThat(read).isEqualTo(entries.subList(0, read.size()));
            assertThat(reader.reach().isWhole()).isFalse();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "garbage, unexpected character 'g'",
        "<<<, unexpected character '<'",
        "<client-came, unexpected end",
        "&amp;, unexpected character '&'"
    })
    void whatFollowsTheEndIsNoCut(String garbage, String problem) throws Exception {
        String text = new String(unpacked(Recordings.written(entries)), UTF_8);

        assertThatThrownBy(
                        () -> Recordings.rest(Recordings.reader((text + garbage).getBytes(UTF_8))))
                .isInstanceOf(DocumentException.class)
                .hasMessageStartingWith("run.auvsml.gz:%d:".formatted(text.lines().count() + 1))
                .hasMessageContaining(problem);
    }

    @Test
    void textBetweenOrAfterEntriesIsNoCut() throws Exception {
        String text = new String(unpacked(Recordings.written(entries.subList(0, 5))), UTF_8);

        for (String garbage : List.of("garbage", "\0\0\0", "< client-came", "<a b=c")) {
            assertThatThrownBy(
                            () ->
                                    Recordings.rest(
                                            Recordings.reader((text + garbage).getBytes(UTF_8))))
                    .as(garbage)
                    .isInstanceOf(DocumentException.class);
        }
    }

    @Test
    void aScenarioIsNoRecording() {
        String text = "<?xml version='1.0'?>\n<!-- a tank -->\n<scenario/>\n";

        assertThatThrownBy(() -> Recordings.reader(text.getBytes(UTF_8)))
                .isInstanceOf(DocumentException.class)
                .hasMessage("run.auvsml.gz is a scenario, no recording");
    }

    @Test
    void aTextOfAnotherKindIsNoRecordingAndSaysWhy() {
        for (String text : List.of("# To read first\n", "x y z", "<html/>", "\u0001\u0002")) {
            assertThatThrownBy(() -> Recordings.reader(text.getBytes(UTF_8)))
                    .as(text)
                    .isInstanceOf(DocumentException.class)
                    .hasMessageMatching("run.auvsml.gz:1:[12]: this is no recording: .+");
        }
    }

    @Test
    void aRecordingIsNoScenario(@TempDir Path folder) throws Exception {
        byte[] packed = Recordings.written(entries);
        for (byte[] bytes : List.of(packed, unpacked(packed))) {
            Path file = Files.write(folder.resolve("run.xml"), bytes);

            assertThatThrownBy(() -> ScenarioLoader.load(getClass().getClassLoader()).load(file))
                    .isInstanceOf(DocumentException.class)
                    .hasMessage(file + " is a recording; replay it with 'auvsim replay'");
        }
    }

    @Test
    void cutOffBeforeItsScenarioIsWholeItIsRefused() throws Exception {
        byte[] file = Recordings.written(List.of());
        for (int length = 0; length < file.length; length++) {
            byte[] cut = Arrays.copyOf(file, length);
            assertThatThrownBy(() -> Recordings.reader(cut))
                    .isInstanceOf(DocumentException.class)
                    .hasMessageStartingWith("run.auvsml.gz: a recording begins with <recording>");
        }
    }

    /** But for bits that fill the last byte of a member's deflated text, and mean nothing. */
    @Test
    void aChangedByteIsNoticedWhereverItIs() throws Exception {
        byte[] file = Recordings.written(entries);
        int noticed = 0;
        for (int i = 0; i < file.length; i += 3) {
            byte[] changed = file.clone();
            changed[i] ^= 0x10;
            try {
                assertThat(Recordings.rest(Recordings.reader(changed))).isEqualTo(entries);
            } catch (DocumentException e) {
                assertThat(e).as("byte %d", i).hasMessageStartingWith("run.auvsml.gz:");
                noticed++;
            }
        }
        assertThat(noticed).isGreaterThan(file.length / 3 * 9 / 10);
    }

    @Test
    void aChangedByteIsToldWithItsMember() throws Exception {
        byte[] file = Recordings.written(entries);
        int first = Recordings.written(List.of()).length;
        file[first + GzipMember.HEADER_LENGTH + 10] ^= 1;

        assertThatThrownBy(() -> Recordings.rest(Recordings.reader(file)))
                .hasMessageStartingWith(
                        ("run.auvsml.gz: the recording is damaged or was changed: its gzip member"
                                        + " 2, from byte %d on, ")
                                .formatted(first));
    }

    @Test
    void oneThatGzipPackedIsToldFromOneThatIsDamaged() throws Exception {
        byte[] file = Recordings.written(entries);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            out.write(unpacked(file));
        }

        assertThatThrownBy(() -> Recordings.reader(packed.toByteArray()))
                .isInstanceOf(DocumentException.class)
                .hasMessage(
                        "run.auvsml.gz: it was packed by gzip, not by auvsim; unpack it with gunzip"
                                + " and use the text");
        file[3] = 0;
        assertThatThrownBy(() -> Recordings.reader(file))
                .hasMessageContaining("the recording is damaged or was changed");
    }

    @Test
    void zerosThatALostFileSystemLeavesAreACut() throws Exception {
        byte[] file = Recordings.written(entries.subList(0, 30));

        RecordingReader reader = Recordings.reader(Arrays.copyOf(file, file.length + 10_000));

        assertThat(Recordings.rest(reader)).isEqualTo(entries.subList(0, 30));
        assertThat(reader.reach().isWhole()).isFalse();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    version="1"    | version="2" | run.auvsml.gz:1:1: root element 1: the recording has the format's version 2, but this auvsim reads version 1; replay it with the auvsim that wrote it
                    <recording     | <recorded   | run.auvsml.gz:1:1: this is no recording: expected the root element <recording>, but found <recorded> at recorded
                    <client-came   | <client-met | run.auvsml.gz:8:1: root element 3: no entry of a recording has the name 'client-met'; there are client-came, client-sent, client-sent-unreadable, client-went, happened, recording-ended, state-hash, step-failed, wait-timed-out
                    pause-sim      | pose-sim    | run.auvsml.gz:9:109: root element 4: unknown element 'pose-simulator-command'; the nearest known name is 'pause-simulator-command' at client-sent/pose-simulator-command
                    request-id="r0"| answer="r0" | run.auvsml.gz:9:93: root element 4: <client-sent> has no attribute 'answer'; the nearest known names are 'index', 'step' at client-sent@answer
                    hash="         | hash="x     | run.auvsml.gz:13:1: root element 8: a hash has 16 digits of 0-9 and a-f, but this is 'x
                    step="5"       | step="2"    | its step must be 4 or more, as in the entry before, but is 2
                    timestamp="3.1"| timestamp="2.5" | its timestamp must be 3.05 or more, as in the entry before, but is 2.5
                    index="1"      | index="0"   | its index must be above 0, that of the input before, but is 0
                    """)
    void whatNoRecordingCanStateIsToldWithItsPlace(String is, String becomes, String sentence)
            throws Exception {
        String text = new String(unpacked(Recordings.written(entries)), UTF_8);
        byte[] edited = text.replaceFirst(is, becomes).getBytes(UTF_8);

        assertThatThrownBy(() -> Recordings.rest(Recordings.reader(edited)))
                .isInstanceOf(DocumentException.class)
                .hasMessageContaining(sentence);
    }

    @Test
    void timeGoesBackWithANewRevision() throws Exception {
        List<Entry> revised =
                List.of(
                        StateHash.of(0, 9, 3.45, 1),
                        new Happened(1, 9, 3.25, List.of()),
                        StateHash.of(1, 10, 3.3, 2));

        assertThat(Recordings.rest(Recordings.reader(Recordings.written(revised))))
                .isEqualTo(revised);
    }

    @Test
    void nothingFollowsTheEnd() throws Exception {
        List<Entry> more =
                List.of(
                        new RecordingEnded(0, 0, 3, "done"),
                        new ClientCame(0, 0, 0, false, 3, 1, "127.0.0.1:4000", Role.ADMIN));

        assertThatThrownBy(() -> Recordings.rest(Recordings.reader(Recordings.written(more))))
                .hasMessageEndingWith("nothing may follow the recording's end");
    }

    @Test
    void aFileThatIsNotThereIsToldSo(@TempDir Path folder) {
        Path file = folder.resolve("none.auvsml.gz");

        assertThatThrownBy(() -> RecordingReader.open(file, Recordings.MAPPER))
                .isInstanceOf(DocumentException.class)
                .hasMessage(file + ": there is no such file");
    }

    @Test
    void aFileIsRead(@TempDir Path folder) throws Exception {
        Path file = Files.write(folder.resolve("run.auvsml.gz"), Recordings.written(entries));

        try (RecordingReader reader = RecordingReader.open(file, Recordings.MAPPER)) {
            assertThat(Recordings.rest(reader)).isEqualTo(entries);
        }
    }

    private static byte[] unpacked(byte[] file) throws IOException {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        try (GZIPInputStream in = new GZIPInputStream(new ByteArrayInputStream(file))) {
            in.transferTo(text);
        }
        return text.toByteArray();
    }
}
