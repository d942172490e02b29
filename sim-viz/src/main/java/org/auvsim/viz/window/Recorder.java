package org.auvsim.viz.window;

import org.auvsim.viz.drawing.Screen;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;

import javax.imageio.ImageIO;

/**
 * Writes pictures of a screen as PNG files, on a thread of its own. Of frames to record one at most
 * is under way: one that comes too soon is left out.
 */
final class Recorder implements AutoCloseable {
    private final Screen screen;
    private final ExecutorService writer =
            Executors.newSingleThreadExecutor(
                    task -> {
                        Thread thread = new Thread(task, "viewer-pictures");
                        thread.setDaemon(true);
                        return thread;
                    });
    private final AtomicBoolean isBusy = new AtomicBoolean();
    private int frames;

    Recorder(Screen screen) {
        this.screen = screen;
    }

    /** Saves the next frame; fails with a sentence. */
    CompletableFuture<Void> save(Path file) {
        return screen.picture().thenAcceptAsync(picture -> write(picture, file), writer);
    }

    /** The file of a numbered frame. */
    static Path frame(Path folder, int number) {
        return folder.resolve(String.format(Locale.ROOT, "frame-%06d.png", number));
    }

    /** What makes a film of numbered frames; it adds a line to a side of an odd number of them. */
    static String film(String folder, int rate) {
        return "ffmpeg -framerate %d -i \"%s\" -vf \"%s\" -pix_fmt yuv420p \"%s\""
                .formatted(
                        rate,
                        folder + "/frame-%06d.png",
                        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                        folder + "/film.mp4");
    }

    /** Begins to number frames anew. */
    void begin() {
        frames = 0;
    }

    /** How many frames were recorded since {@link #begin}. */
    int frames() {
        return frames;
    }

    /** Records the next frame unless the one before is still under way; tells of a failure. */
    void record(Path folder, Consumer<Throwable> failed) {
        if (!isBusy.compareAndSet(false, true)) {
            return;
        }
        frames++;
        var _ =
                save(frame(folder, frames))
                        .whenComplete(
                                (done, failure) -> {
                                    isBusy.set(false);
                                    if (failure != null) {
                                        failed.accept(failure);
                                    }
                                });
    }

    private static void write(BufferedImage picture, Path file) {
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            if (!ImageIO.write(opaque(picture), "png", file.toFile())) {
                throw new IOException("no way to write PNG here");
            }
        } catch (IOException e) {
            throw new UncheckedIOException(
                    "Cannot write the picture %s: %s".formatted(file, e.getMessage()), e);
        }
    }

    private static BufferedImage opaque(BufferedImage picture) {
        BufferedImage plain =
                new BufferedImage(
                        picture.getWidth(), picture.getHeight(), BufferedImage.TYPE_INT_RGB);
        var graphics = plain.createGraphics();
        graphics.drawImage(picture, 0, 0, null);
        graphics.dispose();
        return plain;
    }

    @Override
    public void close() {
        writer.shutdown();
    }
}
