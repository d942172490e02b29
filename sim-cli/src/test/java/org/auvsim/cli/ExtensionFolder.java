package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;

import javax.tools.JavaCompiler;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;

/** A folder of extensions that are compiled for a test. */
record ExtensionFolder(Path path) {
    static final String EFFECT = "org.auvsim.core.entity.Effect";
    static final String RENDERER = "org.auvsim.viz.drawing.Renderer";
    static final String PROCESSOR = "org.auvsim.server.feedback.FeedbackProcessor";

    /** An effect that pushes with a constant force along x. */
    static final String PUSH =
            """
            package own;
            public record OwnPush(double force) implements org.auvsim.core.entity.BodyEffect {
                @Override
                public void add(org.auvsim.core.entity.Block block, int i) {
                    block.addForce(i, new org.auvsim.core.math.Vec3(force, 0, 0));
                }
            }
            """;

    /** A processor that corrects nothing. */
    static final String SHRUG =
            """
            package own;
            public class Shrug implements org.auvsim.server.feedback.FeedbackProcessor {
                @Override
                public Phase phase() {
                    return Phase.AFTER_STEP;
                }
                @Override
                public void process(org.auvsim.server.feedback.Correction correction) {}
            }
            """;

    /** A renderer that paints nothing. */
    static final String CHALK =
            """
            package own;
            import org.auvsim.viz.drawing.*;
            public class Chalk implements Renderer {
                @Override
                public String name() {
                    return "chalk";
                }
                @Override
                public Screen screen(Painter painter) throws ScreenException {
                    throw new ScreenException("Chalk paints nothing.");
                }
                @Override
                public java.awt.image.BufferedImage picture(Painter painter, int wide, int high)
                        throws ScreenException {
                    throw new ScreenException("Chalk paints nothing.");
                }
            }
            """;

    /** Adds a jar of one class and the provider file that names it. */
    Path add(String jar, String service, String provider, String source) throws IOException {
        Path classes = Files.createTempDirectory(path, "classes");
        compile(provider, source, classes);
        return pack(jar, service, provider, classes);
    }

    /** Adds a jar with a provider file and the files of a folder. */
    Path pack(String jar, String service, String provider, Path classes) throws IOException {
        Path file = path.resolve(jar);
        try (OutputStream out = Files.newOutputStream(file);
                JarOutputStream to = new JarOutputStream(out);
                Stream<Path> found = Files.walk(classes)) {
            write(
                    to,
                    "META-INF/services/" + service,
                    ("# own\n" + provider + "\n").getBytes(UTF_8));
            for (Path each : found.filter(Files::isRegularFile).toList()) {
                String name = classes.relativize(each).toString().replace('\\', '/');
                write(to, name, Files.readAllBytes(each));
            }
        }
        return file;
    }

    private static void write(JarOutputStream to, String name, byte[] bytes) throws IOException {
        to.putNextEntry(new JarEntry(name));
        to.write(bytes);
        to.closeEntry();
    }

    /** Compiles one class. */
    static void compile(String name, String source, Path classes) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        URI place = URI.create("string:///" + name.replace('.', '/') + ".java");
        var file =
                new SimpleJavaFileObject(place, SimpleJavaFileObject.Kind.SOURCE) {
                    @Override
                    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                        return source;
                    }
                };
        List<String> options =
                List.of(
                        "-proc:none",
                        "-cp",
                        System.getProperty("java.class.path"),
                        "-d",
                        classes.toString());
        assertThat(compiler.getTask(null, null, null, options, null, List.of(file)).call())
                .isTrue();
    }
}
