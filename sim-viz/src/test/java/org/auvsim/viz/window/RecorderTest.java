package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.viz.drawing.Screen;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;

import javax.imageio.ImageIO;

class RecorderTest {
    @TempDir private Path folder;

    @Test
    void aFrameThatComesTooSoonIsLeftOut() throws Exception {
        SlowScreen screen = new SlowScreen();
        try (Recorder recorder = new Recorder(screen)) {
            recorder.record(folder, failure -> {});
            recorder.record(folder, failure -> {});
            assertThat(recorder.frames()).isEqualTo(1);
            assertThat(screen.asked).hasSize(1);
        }
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
