package org.auvsim.cli;

import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.Reach;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.viz.Renderers;
import org.auvsim.viz.ViewStart;
import org.auvsim.viz.Viewer;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.Renderer;
import org.auvsim.viz.drawing.ScreenException;
import org.auvsim.viz.source.LiveSource;
import org.auvsim.viz.source.Playback;
import org.auvsim.viz.source.RecordedSource;
import org.auvsim.viz.source.Source;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;

import javax.imageio.ImageIO;

/** {@code auvsim view}. */
@Command(
        name = "view",
        description = "Shows a simulator or a recording in three dimensions, and steers it.",
        footer = {
            "",
            "What may be steered is what the server's role allows; docs/viewing.md has keys and"
                    + " menus.",
            "With --picture there is no window: one picture is painted as PNG.",
            "",
            "Examples:",
            "  auvsim view",
            "  auvsim view run.auvsml.gz",
            "  auvsim view run.auvsml.gz --picture start.png --at 2.5 --look top"
        })
final class View implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(
            arity = "0..1",
            paramLabel = "HOST:PORT|RECORDING",
            defaultValue = Address.STANDARD,
            description = "Where a simulator listens, or a recording; by default ${DEFAULT-VALUE}.")
    private String target = Address.STANDARD;

    @Option(
            names = "--renderer",
            paramLabel = "NAME",
            defaultValue = "jme",
            description =
                    "What paints: jme (OpenGL, by default), or one of an extension, as osp, which"
                            + " needs no OpenGL.")
    private String renderer = "jme";

    @Option(names = "--follow", paramLabel = "NAME|ID", description = "The camera goes with it.")
    private Optional<String> follow = Optional.empty();

    @Option(
            names = "--look",
            paramLabel = "SIDE",
            defaultValue = "OBLIQUE",
            description = "From where: ${COMPLETION-CANDIDATES}.")
    private StandardView look = StandardView.OBLIQUE;

    @Option(names = "--light", description = "Dark before light.")
    private boolean light;

    @Option(
            names = "--picture",
            paramLabel = "FILE",
            description = "Paints one picture as PNG and ends.")
    private Optional<Path> picture = Optional.empty();

    @Option(
            names = "--size",
            paramLabel = "WIDTHxHEIGHT",
            converter = PictureSize.Converter.class,
            defaultValue = "1280x800",
            description = "The picture's, in pixels; by default ${DEFAULT-VALUE}.")
    private PictureSize size = new PictureSize(1280, 800);

    @Option(
            names = "--at",
            paramLabel = "SECONDS",
            description = "The time of a recording that is shown first; by default its start.")
    private Optional<Double> at = Optional.empty();

    @Override
    public Integer call() throws DocumentException, ConnectionException {
        try {
            show(painter());
        } catch (ScreenException e) {
            throw new UserError(String.valueOf(e.getMessage()), e);
        }
        return 0;
    }

    /** What is wrong with the options is found before a recording is read, which may take long. */
    private Renderer painter() throws ScreenException {
        Renderer painter = Renderers.named(renderer, ContextClasses.loader());
        if (picture.isPresent()) {
            requirePng(picture.get());
        } else if (isFile()) {
            Viewer.requireDisplay();
        }
        return painter;
    }

    private static void requirePng(Path file) {
        String name = String.valueOf(file.getFileName());
        if (!name.toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw new UserError(
                    "--picture is a PNG file, but %s has another name: name it %s.png."
                            .formatted(file, name.replaceFirst("(?<=.)\\.[^.]*$", "")));
        }
        if (!Files.isDirectory(file.toAbsolutePath().resolveSibling(""))) {
            throw FileTrouble.writing(file, new NoSuchFileException(file.toString()));
        }
    }

    private void show(Renderer painter)
            throws DocumentException, ConnectionException, ScreenException {
        try (Source source = source()) {
            at.ifPresent(time -> seek(source, time));
            Viewer viewer = new Viewer(source, painter);
            ViewStart start = new ViewStart(!light, look, follow);
            if (picture.isPresent()) {
                write(viewer.picture(start, size.width(), size.height()), picture.get());
            } else {
                viewer.show(start);
            }
        }
    }

    private Source source() throws DocumentException, ConnectionException {
        if (isFile()) {
            Path file = Path.of(target);
            ShareRead told = new ShareRead(file, spec.commandLine().getErr(), System::nanoTime);
            RecordedSource recording =
                    RecordedSource.open(file, AuvsmlMapper.load(ContextClasses.loader()), told::at);
            tell(file, recording.reach());
            return recording;
        }
        Address address = address();
        return LiveSource.connect(
                address.host(), address.port(), MessageCatalogue.load(ContextClasses.loader()));
    }

    private void tell(Path file, Reach reach) {
        if (!reach.isWhole()) {
            PrintWriter err = spec.commandLine().getErr();
            err.printf(
                    "%s: notice: it is shown up to %s s: %s.%n",
                    file, reach.timestamp(), reach.reason());
            err.flush();
        }
    }

    private Address address() {
        try {
            return new Address.Converter().convert(target);
        } catch (TypeConversionException e) {
            throw new UserError(
                    "There is no recording '%s', and as a simulator's address it is wrong: %s."
                            .formatted(target, e.getMessage()),
                    e);
        }
    }

    /** A name with a colon is an address, but for that of a recording. */
    private boolean isFile() {
        return target.endsWith(".auvsml.gz")
                || target.endsWith(".auvsml")
                || (!target.contains(":") && Files.exists(Path.of(target)));
    }

    private void seek(Source source, double time) {
        Playback playback =
                source.playback()
                        .orElseThrow(
                                () ->
                                        new UserError(
                                                "--at is for recordings, but %s is a simulator."
                                                        .formatted(target)));
        if (!(time >= playback.start() && time <= playback.end())) {
            throw new UserError(
                    "--at must be within the recording, from %s to %s s, but is %s s."
                            .formatted(playback.start(), playback.end(), time));
        }
        playback.seek(time);
    }

    private void write(BufferedImage image, Path file) {
        try {
            // By a stream: ImageIO tells of a folder that is missing only by returning.
            try (var out = Files.newOutputStream(file)) {
                ImageIO.write(image, "png", out);
            }
        } catch (IOException e) {
            throw FileTrouble.writing(file, e);
        }
        spec.commandLine().getOut().println("picture written to " + Rows.place(file));
    }
}
