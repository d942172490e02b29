package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.viz.drawing.Screen;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;

import javax.imageio.ImageIO;

class RecorderTest {
    @TempDir private Path folder;

    @Test
    void framesThatWereMissedAreTheOneBeforeAgain() throws Exception {
        SlowScreen screen = new SlowScreen();
        AtomicLong millis = new AtomicLong(7000);
        try (Recorder recorder = new Recorder(screen, () -> millis.get() * 1_000_000)) {
            recorder.begin(25);
            recorder.record(folder, failure -> {});
            millis.addAndGet(20);
            screen.completes(1);
            recorder.end(folder).get(30, TimeUnit.SECONDS);
            recorder.record(folder, failure -> {}); // none is due
            millis.addAndGet(100);
            recorder.record(folder, failure -> {});
            recorder.record(folder, failure -> {}); // one is under way
            assertThat(recorder.frames()).isEqualTo(4);
            assertThat(screen.asked).hasSize(1);
            screen.completes(2);
            millis.addAndGet(80);
            recorder.end(folder).get(30, TimeUnit.SECONDS);
            assertThat(recorder.frames()).isEqualTo(5); // 0.2 s
            assertThat(List.of(width(1), width(2), width(3), width(4), width(5)))
                    .containsExactly(1, 1, 1, 2, 2);
            assertThat(Recorder.frame(folder, 6)).doesNotExist();
        }
    }

    private int width(int frame) throws IOException {
        return ImageIO.read(Recorder.frame(folder, frame).toFile()).getWidth();
    }

    @Test
    void aPictureIsAPngFile() throws Exception {
        SlowScreen screen = new SlowScreen();
        try (Recorder recorder = new Recorder(screen)) {
            Path file = folder.resolve("new").resolve("a.png");
            CompletableFuture<Void> saved = recorder.save(file);
            screen.asked.remove().complete(new BufferedImage(7, 5, BufferedImage.TYPE_INT_ARGB));
            saved.get(30, TimeUnit.SECONDS);
            assertThat(ImageIO.read(file.toFile()).getWidth()).isEqualTo(7);
        }
    }

    @Test
    void aPictureThatCannotBeWrittenIsASentence() throws Exception {
        SlowScreen screen = new SlowScreen();
        try (Recorder recorder = new Recorder(screen)) {
            Path file = Files.createFile(folder.resolve("file")).resolve("a.png");
            CompletableFuture<Void> saved = recorder.save(file);
            screen.asked.remove().complete(new BufferedImage(7, 5, BufferedImage.TYPE_INT_ARGB));
            assertThatThrownBy(saved::join)
                    .isInstanceOf(CompletionException.class)
                    .cause()
                    .hasMessageStartingWith("Cannot write the picture " + file);
        }
    }

    @Test
    void tellsHowFramesBecomeAFilm() {
        assertThat(Recorder.film("f", 25))
                .startsWith("ffmpeg -framerate 25 -i \"")
                .contains("frame-%06d.png")
                .contains("pad=ceil(iw/2)*2:ceil(ih/2)*2"); // no film has an odd side
        assertThat(Recorder.frame(Path.of("f"), 12)).hasFileName("frame-000012.png");
    }

    private static final class SlowScreen implements Screen {
        private final Deque<CompletableFuture<BufferedImage>> asked = new ArrayDeque<>();

        void completes(int width) {
            asked.remove().complete(new BufferedImage(width, 1, BufferedImage.TYPE_INT_ARGB));
        }

        @Override
        public Component component() {
            throw new UnsupportedOperationException("it has none");
        }

        @Override
        public CompletableFuture<Void> start() {
            return CompletableFuture.completedFuture(null);
        }

        @Override
        public CompletableFuture<BufferedImage> picture() {
            CompletableFuture<BufferedImage> next = new CompletableFuture<>();
            asked.add(next);
            return next;
        }

        @Override
        public double frameRate() {
            return 0;
        }

        @Override
        public void close() {}
    }
}
