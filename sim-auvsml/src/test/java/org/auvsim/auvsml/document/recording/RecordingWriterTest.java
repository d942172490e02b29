package org.auvsim.auvsml.document.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.recording.Entry;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Random;

class RecordingWriterTest {
    private final List<Entry> entries = Recordings.entries(20, new Random(2));

    @Test
    void whatIsFlushedIsReadableThoughNothingMoreComes() throws Exception {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        RecordingWriter writer = new RecordingWriter(file, Recordings.MAPPER);
        writer.begin(Recordings.BEGINNING, Recordings.scenario());
        for (Entry entry : entries.subList(0, 10)) {
            writer.write(entry);
        }
        writer.flush();
        writer.write(entries.get(10));

        RecordingReader reader = Recordings.reader(file.toByteArray());

        assertThat(Recordings.rest(reader)).isEqualTo(entries.subList(0, 10));
    }

    @Test
    void nothingIsWrittenWithoutEntries() throws Exception {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        RecordingWriter writer = new RecordingWriter(file, Recordings.MAPPER);
        writer.begin(Recordings.BEGINNING, Recordings.scenario());
        int size = file.size();
        writer.flush();
        writer.close();

        assertThat(file.size()).isEqualTo(size);
    }

    @Test
    void longRecordingsAreHandedOverThoughNobodyFlushes() throws Exception {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        RecordingWriter writer = new RecordingWriter(file, Recordings.MAPPER);
        writer.begin(Recordings.BEGINNING, Recordings.scenario());
        List<Entry> many = Recordings.entries(5_000, new Random(3));
        for (Entry entry : many) {
            writer.write(entry);
        }

        List<Entry> read = Recordings.rest(Recordings.reader(file.toByteArray()));

        assertThat(read.size()).isGreaterThan(many.size() / 3);
        assertThat(read).isEqualTo(many.subList(0, read.size()));
    }

    @Test
    void aFullDiskIsToldAndLeavesWhatWasWrittenReadable() throws Exception {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        RecordingWriter writer = new RecordingWriter(new SmallDisk(file, 4_000), Recordings.MAPPER);
        writer.begin(Recordings.BEGINNING, Recordings.scenario());
        assertThatThrownBy(
                        () -> {
                            for (Entry entry : entries) {
                                writer.write(entry);
                                writer.flush();
                            }
                        })
                .isInstanceOf(IOException.class)
                .hasMessage("No space left on device");

        List<Entry> read = Recordings.rest(Recordings.reader(file.toByteArray()));

        assertThat(file.size()).isEqualTo(4_000);
        assertThat(read).isNotEmpty().isEqualTo(entries.subList(0, read.size()));
    }
}
