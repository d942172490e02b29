package org.auvsim.viz.window;

import org.auvsim.viz.drawing.Screen;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

import javax.imageio.ImageIO;

/**
 * Writes pictures of a screen as PNG files, on a thread of its own. Of frames to record one at most
 * is under way; those that were due meanwhile are the one before again, so that a film of them
 * lasts as long as it was recorded.
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
    private final LongSupplier nanoClock;
    private CompletableFuture<Void> newest = CompletableFuture.completedFuture(null);
    private OptionalLong start = OptionalLong.empty();
    private int rate = 1;
    private int frames;

    Recorder(Screen screen) {
        this(screen, System::nanoTime);
    }

    /** By a clock of its own (ns). */
    Recorder(Screen screen, LongSupplier nanoClock) {
        this.screen = screen;
        this.nanoClock = nanoClock;
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

    /** Begins to number frames anew, so many a second. */
    void begin(int framesASecond) {
        rate = framesASecond;
        frames = 0;
        start = OptionalLong.empty();
        newest = CompletableFuture.completedFuture(null);
    }

    /** How many frames were recorded since {@link #begin}. */
    int frames() {
        return frames;
    }

    /**
     * Records what is seen now if a frame is due and the one before is not under way any more;
     * tells of a failure.
     */
    void record(Path folder, Consumer<Throwable> failed) {
        int before = frames;
        int due = passed() + 1;
        if (due == before || !newest.isDone()) {
            return;
        }
        frames = due;
        newest =
                screen.picture()
                        .thenAcceptAsync(
                                picture -> {
                                    repeat(folder, before, due - 1);
                                    write(picture, frame(folder, due));
                                },
                                writer)
                        .whenComplete(
                                (done, failure) -> {
                                    if (failure != null) {
                                        failed.accept(failure);
                                    }
                                });
    }

    /** Records no more; done when there are frames for all the time that has passed. */
    CompletableFuture<Void> end(Path folder) {
        int before = frames;
        frames = Math.max(before, passed());
        int last = frames;
        newest = newest.thenRunAsync(() -> repeat(folder, before, last), writer);
        return newest;
    }

    /** For how many frames time has passed since the first one. */
    private int passed() {
        long now = nanoClock.getAsLong();
        if (start.isEmpty()) {
            start = OptionalLong.of(now);
        }
        return (int) Math.floorDiv((now - start.getAsLong()) * rate, 1_000_000_000L);
    }

    /** The frames after one, up to another one, are the same. */
    private static void repeat(Path folder, int frame, int last) {
        for (int number = frame + 1; frame > 0 && number <= last; number++) {
            Path file = frame(folder, number);
            try {
                Files.copy(frame(folder, frame), file, StandardCopyOption.REPLACE_EXISTING);
            } catch (IOException e) {
                throw unwritten(file, e);
            }
        }
    }

    private static void write(BufferedImage picture, Path file) {
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            if (!ImageIO.write(opaque(picture), "png", file.toFile())) {
                throw new IOException("no way to write PNG here");
            }
        } catch (IOException e) {
            throw unwritten(file, e);
        }
    }

    private static UncheckedIOException unwritten(Path file, IOException e) {
        return new UncheckedIOException(
                "Cannot write the picture %s: %s".formatted(file, e.getMessage()), e);
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
