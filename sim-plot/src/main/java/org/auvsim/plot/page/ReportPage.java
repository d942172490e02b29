package org.auvsim.plot.page;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Block.Text;
import org.auvsim.plot.page.Report.Section;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A report as an HTML page in one file: it loads nothing, and its content security policy lets
 * nothing run but the scripts that it was written with.
 */
public final class ReportPage {
    /** Points of a curve that the page gets at most. */
    private static final int MOST_POINTS = 2_000;

    private static final String CHART_JS =
            "/META-INF/resources/webjars/chart.js/4.5.1/dist/chart.umd.min.js";

    private final Report report;
    private final List<Chart> charts = new ArrayList<>();

    private ReportPage(Report report) {
        this.report = report;
    }

    /**
     * Writes {@code report.html} into a folder.
     *
     * @return its path
     * @throws IOException if it cannot be written
     */
    public static Path write(Path folder, Report report) throws IOException {
        Path file = folder.resolve("report.html");
        Files.writeString(file, html(report));
        return file;
    }

    /** The whole page. */
    public static String html(Report report) {
        return new ReportPage(report).html();
    }

    private String html() {
        String style = resource("report.css");
        String library = resource(CHART_JS);
        String script = resource("report.js");
        String body = body();
        return """
        <!doctype html>
        <html lang="en">
        <head>
        <meta charset="utf-8">
        <meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src '%s'; \
        script-src '%s' '%s'; base-uri 'none'; form-action 'none'">
        <meta name="viewport" content="width=device-width, initial-scale=1">
        <meta name="color-scheme" content="light dark">
        <title>%s</title>
        <style>%s</style>
        </head>
        <body>
        %s<script type="application/json" id="charts">%s</script>
        <script>%s</script>
        <script>%s</script>
        </body>
        </html>
        """
                .formatted(
                        hash(style),
                        hash(library),
                        hash(script),
                        escaped(report.title()),
                        style,
                        body,
                        Json.charts(charts),
                        library,
                        script);
    }

    private String body() {
        StringBuilder out = new StringBuilder("<main>\n");
        out.append("<h1>%s</h1>\n".formatted(escaped(report.title())));
        out.append("<p class=\"summary\">%s</p>\n".formatted(escaped(report.summary())));
        for (Section section : report.sections()) {
            out.append(html(section));
        }
        return out.append("</main>\n").toString();
    }

    private String html(Section section) {
        String heading = escaped(section.heading());
        String blocks = section.blocks().stream().map(this::html).collect(Collectors.joining());
        return section.isFolded()
                ? """
                <details>
                <summary><h2>%s</h2></summary>
                <div class="beside">
                %s</div>
                </details>
                """
                        .formatted(heading, blocks)
                : "<section>\n<h2>%s</h2>\n%s</section>\n".formatted(heading, blocks);
    }

    private String html(Block block) {
        return switch (block) {
            case Text text -> "<p>%s</p>\n".formatted(escaped(text.sentences()));
            case Table table -> html(table);
            case Chart chart -> html(chart);
        };
    }

    private static String html(Table table) {
        StringBuilder out = new StringBuilder("<figure>\n<div class=\"wide\"><table>\n");
        append(table, table.header(), "th", out);
        table.rows().forEach(row -> append(table, row, "td", out));
        return out + "</table></div>\n" + caption(table.reading()) + "</figure>\n";
    }

    private static void append(Table table, List<String> row, String cell, StringBuilder out) {
        out.append("<tr>");
        for (int column = 0; column < row.size(); column++) {
            out.append(
                    "<%s%s>%s</%s>"
                            .formatted(
                                    cell,
                                    table.isOfWords(column) ? " class=\"words\"" : "",
                                    escaped(row.get(column)),
                                    cell));
        }
        out.append("</tr>\n");
    }

    private String html(Chart chart) {
        List<Curve> curves = chart.curves().stream().map(c -> c.decimated(MOST_POINTS)).toList();
        charts.add(chart.with(curves));
        return """
        <figure>
        <h3>%s</h3>
        <div class="chart"><canvas role="img" aria-label="%s"></canvas></div>
        %s</figure>
        """
                .formatted(
                        escaped(chart.title()), escaped(chart.title()), caption(chart.reading()));
    }

    private static String caption(String reading) {
        return reading.isEmpty() ? "" : "<figcaption>%s</figcaption>\n".formatted(escaped(reading));
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    private static String hash(String inline) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(inline.getBytes(UTF_8));
            return "sha256-" + Base64.getEncoder().encodeToString(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java platform has SHA-256", e);
        }
    }

    private static String resource(String name) {
        try (InputStream in = ReportPage.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new IllegalStateException("the build lacks the resource " + name);
            }
            return new String(in.readAllBytes(), UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
