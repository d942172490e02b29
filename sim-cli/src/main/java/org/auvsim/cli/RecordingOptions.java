package org.auvsim.cli;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.server.replay.Recorder;

import picocli.CommandLine.Option;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/** The options {@code --record}, {@code --hash-every} and {@code --force}. */
final class RecordingOptions {
    @Option(
            names = "--record",
            paramLabel = "FILE.auvsml.gz",
            description =
                    "Records all that decides the simulation's course, and what comes of it, for"
                            + " 'auvsim replay'.")
    private Optional<Path> file = Optional.empty();

    @Option(
            names = "--hash-every",
            paramLabel = "STEPS",
            description =
                    "The recording has a hash of the state each so many steps; by default "
                            + Recording.USUAL_HASH_EVERY
                            + ".")
    private Optional<Integer> hashEvery = Optional.empty();

    @Option(names = "--force", description = "Overwrites a recording that is there already.")
    private boolean force;

    private final Disk disk;

    /** Where recordings are written. */
    interface Disk {
        OutputStream open(Path file, OpenOption... options) throws IOException;
    }

    RecordingOptions() {
        this(Files::newOutputStream);
    }

    RecordingOptions(Disk disk) {
        this.disk = disk;
    }

    /**
     * Begins the recording of a scenario, if one is wanted.
     *
     * @throws UserError if that cannot be done
     */
    RecordingUnderWay start(Scenario scenario, String server) {
        requireSense();
        Recording recording =
                new Recording(
                        Recording.VERSION, server, hashEvery.orElse(Recording.USUAL_HASH_EVERY));
        return new RecordingUnderWay(file.map(target -> start(target, recording, scenario)));
    }

    private void requireSense() {
        if (hashEvery.isPresent() && hashEvery.get() < 1) {
            throw new UserError(
                    "--hash-every must be 1 or more, but is %d.".formatted(hashEvery.get()));
        }
        if (file.isEmpty() && (hashEvery.isPresent() || force)) {
            throw new UserError(
                    "%s is for a recording; name its file by --record."
                            .formatted(hashEvery.isPresent() ? "--hash-every" : "--force"));
        }
        file.filter(Files::isDirectory)
                .ifPresent(
                        folder -> {
                            throw new UserError(
                                    "--record needs a file, but %s is a folder.".formatted(folder));
                        });
    }

    private Recorder start(Path target, Recording recording, Scenario scenario) {
        AuvsmlMapper mapper = AuvsmlMapper.load(ContextClasses.loader());
        try {
            return Recorder.start(new RecordingWriter(open(target), mapper), recording, scenario);
        } catch (FileAlreadyExistsException e) {
            throw new UserError(
                    "%s is there already; name another file, or overwrite it with --force."
                            .formatted(target),
                    e);
        } catch (IOException e) {
            throw FileTrouble.writing(target, e);
        }
    }

    private OutputStream open(Path target) throws IOException {
        OpenOption ifThere =
                force ? StandardOpenOption.TRUNCATE_EXISTING : StandardOpenOption.CREATE_NEW;
        return disk.open(target, StandardOpenOption.CREATE, StandardOpenOption.WRITE, ifThere);
    }
}
