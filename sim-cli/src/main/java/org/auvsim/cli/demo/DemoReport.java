package org.auvsim.cli.demo;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Locale;

/**
 * What is left of a demonstration: {@code demo.png}, and {@code demo.html} with the figures too.
 */
final class DemoReport {
    /** Why two rows of the table are alike. */
    static final String WHY_ALIKE =
            "The two corrections are alike here because nothing is in the robot's way: both end a"
                    + " step where the robot is, with the momentum that was projected. Only vector"
                    + " adjustment would meet an obstacle on the way there.";

    private DemoReport() {}

    /** Makes the folder if need be, and sees that it can be written to. */
    static void prepare(Path folder) throws IOException {
        Files.createDirectories(folder);
        if (!Files.isWritable(folder)) {
            throw new AccessDeniedException(folder.toString());
        }
    }

    /**
     * Writes both files into a folder; returns the HTML's path.
     *
     * @param tracks of the flights, those of one round first
     * @param learning the whole flight on which the server learned
     * @param learned what it has learned
     */
    static Path write(Path folder, List<Track> tracks, Track learning, String learned)
            throws IOException {
        byte[] picture = DemoPlot.png(tracks, learning);
        Files.write(folder.resolve("demo.png"), picture);
        Path html = folder.resolve("demo.html");
        Files.writeString(html, html(tracks, learned, picture));
        return html;
    }

    private static String html(List<Track> tracks, String learned, byte[] picture) {
        StringBuilder rows = new StringBuilder();
        for (Track track : tracks) {
            rows.append(
                    String.format(
                            Locale.ROOT,
                            "<tr><td>%s</td><td>%d</td><td>%.3f</td><td>%.3f</td></tr>%n",
                            track.name(),
                            track.corrections(),
                            track.rmsError(),
                            track.largestError()));
        }
        return """
        <!doctype html>
        <html lang="en"><head><meta charset="utf-8"><title>auvsim demo</title>
        <style>
        body { font-family: system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem }
        table { border-collapse: collapse } th, td { padding: .3rem 1rem; text-align: right }
        th:first-child, td:first-child { text-align: left } tr { border-bottom: 1px solid #ccc }
        img { max-width: 100%% }
        </style></head><body>
        <h1>One robot, five simulations of it</h1>
        <p>The same commands go to the simulated and to the physical robot, which feels a drag
        and a current that the scenario lacks. Errors are taken where no feedback came.</p>
        <table><tr><th>simulation</th><th>corrections</th><th>RMS error (m)</th>
        <th>largest error (m)</th></tr>
        %s</table>
        <p>%s</p>
        <p>What the server has learned: %s</p>
        <p><img alt="The true path and the three simulated ones"
        src="data:image/png;base64,%s"></p>
        </body></html>
        """
                .formatted(rows, WHY_ALIKE, learned, Base64.getEncoder().encodeToString(picture));
    }
}
