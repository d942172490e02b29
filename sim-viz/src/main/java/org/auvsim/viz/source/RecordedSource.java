package org.auvsim.viz.source;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.MissingFile;
import org.auvsim.auvsml.document.recording.Reach;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.viz.scene.Scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Shows a recording, whose time can be chosen. It is read once, as a whole, into what is bounded:
 * of a long one every second state is shown, or every fourth, and so on.
 *
 * <p>Shown of a time is what was finally true for it. Where the recorded world goes back, to a
 * snapshot or its beginning, what was told of the time after is forgotten; where late feedback has
 * corrected the past, its collisions are the corrected ones, but the places stay those told first,
 * since the recording tells no others. Commands are shown as carried out; a recording does not say
 * which were refused, nor what behaviors inside the world did to forces and propulsors.
 */
public final class RecordedSource implements Source {
    /** So many states are kept at most: some 300 MB. */
    static final long MOST_STATES = 6_000_000;

    private final String name;
    private final String notices;
    private final Reach reach;
    private final PlayHead head;
    private final ShownChronicle shown;

    private RecordedSource(String name, Chronicle chronicle, Reach reach) {
        this.name = name;
        this.notices = notices(reach, chronicle.stride());
        this.reach = reach;
        this.head = new PlayHead(chronicle.steps());
        this.shown = new ShownChronicle(chronicle);
        shown.show(head.time());
    }

    /**
     * Reads a file, which takes as long as that is.
     *
     * @param mapper knows the messages and components that the recording may hold
     * @param progress is told now and then which share of it has been read, 0 to 1, on this thread
     * @throws DocumentException if it cannot be read, or is damaged or no recording
     */
    public static RecordedSource open(Path file, AuvsmlMapper mapper, Consumer<Double> progress)
            throws DocumentException {
        return open(file, mapper, progress, MOST_STATES);
    }

    /** The same, keeping about so many states at most. */
    static RecordedSource open(Path file, AuvsmlMapper mapper, Consumer<Double> progress, long most)
            throws DocumentException {
        try (CountedStream in = new CountedStream(Files.newInputStream(file))) {
            Share share = new Share(in, Files.size(file), progress);
            RecordingReader reader = RecordingReader.of(in, file.toString(), mapper);
            Chronicle chronicle = ChronicleReader.read(reader, file.toString(), most, share::tell);
            progress.accept(1.0);
            return new RecordedSource(
                    String.valueOf(file.getFileName()), chronicle, reader.reach());
        } catch (NoSuchFileException e) {
            throw new DocumentException(MissingFile.sentence(file), e);
        } catch (IOException e) {
            throw new DocumentException(file + " cannot be read: " + e.getMessage(), e);
        }
    }

    private static String notices(Reach reach, int stride) {
        List<String> notices = new ArrayList<>();
        if (!reach.isWhole()) {
            notices.add("; it was cut off and is shown as far as it goes");
        }
        if (stride > 1) {
            notices.add("; it is long: one state of %d is shown".formatted(stride));
        }
        return String.join("", notices);
    }

    /** How far the recording goes. */
    public Reach reach() {
        return reach;
    }

    @Override
    public Scene scene() {
        return shown.scene();
    }

    @Override
    public void bring(long nanos) {
        synchronized (shown) {
            shown.show(head.advance(nanos));
        }
    }

    @Override
    public String status() {
        return String.format(
                Locale.ROOT,
                "%s, %.2f of %.2f s, %s%s",
                name,
                head.time(),
                head.end(),
                head.isPlaying() ? "playing" : "standing still",
                notices);
    }

    @Override
    public Optional<Steering> steering() {
        return Optional.empty();
    }

    @Override
    public Optional<Playback> playback() {
        return Optional.of(head);
    }

    /** Stands still; the file was closed when it was read. */
    @Override
    public void close() {
        head.play(false);
    }

    /** Tells how far a file has been read, each time when a hundredth more is. */
    private static final class Share {
        private final CountedStream in;
        private final long size;
        private final Consumer<Double> progress;
        private long told;

        Share(CountedStream in, long size, Consumer<Double> progress) {
            this.in = in;
            this.size = size;
            this.progress = progress;
        }

        void tell() {
            long hundredths = Math.min(100 * in.count() / Math.max(size, 1), 99);
            if (hundredths > told) {
                told = hundredths;
                progress.accept(hundredths / 100.0);
            }
        }
    }
}
