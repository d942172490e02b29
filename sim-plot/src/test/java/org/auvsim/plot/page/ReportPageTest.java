package org.auvsim.plot.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Block.Table;
import org.auvsim.plot.page.Block.Text;
import org.auvsim.plot.page.Curve.Mark;
import org.auvsim.plot.page.Curve.Point;
import org.auvsim.plot.page.Report.Section;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

class ReportPageTest {
    @TempDir private Path folder;
    private String page = "";

    @BeforeEach
    void write() throws IOException {
        List<Point> points = List.of(new Point(0, 1), new Point(0.5, Double.NaN));
        Report report =
                new Report(
                        "A & B",
                        "less < more",
                        List.of(
                                Section.of(
                                        "First",
                                        new Text("Said."),
                                        new Table(
                                                List.of("a", "b"),
                                                List.of(List.of("1", "<2>")),
                                                "Read."),
                                        new Chart(
                                                        "Curves",
                                                        "t (s)",
                                                        "y \"(m)\"",
                                                        List.of(
                                                                new Curve(
                                                                        "</script>",
                                                                        Mark.DASHED,
                                                                        points)),
                                                        "Seen.")
                                                .showing(List.of(-2.0, 3.0)))));
        page = Files.readString(ReportPage.write(folder, report));
    }

    @Test
    void textsAreEscaped() {
        assertThat(page)
                .contains("<title>A &amp; B</title>")
                .contains("<p class=\"summary\">less &lt; more</p>")
                .contains("<td>1</td><td>&lt;2&gt;</td>")
                .contains("<figcaption>Seen.</figcaption>");
    }

    @Test
    void chartsAreDataThatEndNoScript() {
        assertThat(page)
                .contains(
                        "[{\"title\":\"Curves\",\"x\":\"t (s)\",\"y\":\"y \\u0022(m)\\u0022\","
                            + "\"axes\":\"even\",\"alsoUp\":[-2.0,3.0],\"curves\":[{\"name\":\"\\u003c/script\\u003e\","
                            + "\"mark\":\"dashed\",\"x\":[0.0,0.5],\"y\":[1.0,null]}]}]");
    }

    /** What the policy lets run is what the page has in it, and nothing comes from elsewhere. */
    @Test
    void thePolicyNamesWhatIsInThePageAndNothingIsLoaded() throws GeneralSecurityException {
        String policy = first("Content-Security-Policy\" content=\"([^\"]*)\"", page);
        assertThat(policy)
                .startsWith("default-src 'none'; ")
                .doesNotContain("unsafe")
                .doesNotContain("http");
        List<String> scripts =
                Pattern.compile("<script>(.*?)</script>", Pattern.DOTALL)
                        .matcher(page)
                        .results()
                        .map(m -> m.group(1))
                        .toList();
        assertThat(scripts).hasSize(2).first().asString().contains("Chart.js v4");
        for (String script : scripts) {
            assertThat(policy).contains("'sha256-" + digest(script) + "'");
        }
        assertThat(policy)
                .contains("style-src 'sha256-" + digest(first("<style>(.*?)</style>", page)) + "'");
        assertThat(page).doesNotContain("<link").doesNotContain(" src=");
    }

    /** Of the size and colour that they have in the chart, wide enough to show beside a line. */
    @Test
    void dotsAreInTheLegendAsTheyAreDrawn() {
        String script = page.substring(page.lastIndexOf("<script>"));
        assertThat(script)
                .contains("generateLabels", "pointRadius: radius[curve.mark]")
                .contains("ink.arc(x, 5, radius[curve.mark], 0, 2 * Math.PI)")
                .contains("'dots' ? '--measured'");
        double radius = Double.parseDouble(first("dots: ([0-9.]+) }", script));
        double line = Double.parseDouble(first("borderWidth: .* : ([0-9.]+),", script));
        assertThat(2 * radius).isGreaterThan(2 * line);
        assertThat(page).contains("--measured: #");
    }

    private static String first(String pattern, String text) {
        Matcher matcher = Pattern.compile(pattern, Pattern.DOTALL).matcher(text);
        assertThat(matcher.find()).as(pattern).isTrue();
        return matcher.group(1);
    }

    private static String digest(String text) throws GeneralSecurityException {
        byte[] hash = MessageDigest.getInstance("SHA-256").digest(text.getBytes(UTF_8));
        return Base64.getEncoder().encodeToString(hash);
    }

    @Test
    void aFoldedSectionShowsItsHeadingAlone() {
        Section folded = new Section("Details", true, List.of(new Text("Inside.")));
        assertThat(ReportPage.html(new Report("", "", List.of(folded))))
                .contains(
                        """
                        <details>
                        <summary><h2>Details</h2></summary>
                        <div class="beside">
                        <p>Inside.</p>
                        </div>
                        </details>
                        """);
    }

    @Test
    void whatGrowsByFactorsHasAxesOfPowersOfTen() {
        Chart grows = Chart.logarithmic("Growth", "t (s)", "y (m)", List.of(), "");
        assertThat(ReportPage.html(new Report("", "", List.of(Section.of("", grows)))))
                .contains("\"y\":\"y (m)\",\"axes\":\"logarithmic\"")
                .contains("axes === 'logarithmic' ? 'logarithmic' : 'linear'");
    }

    /** A shade at its edge says that there is more. */
    @Test
    void aTableThatIsWiderThanAPhoneIsScrolledByItself() {
        assertThat(first("<style>(.*?)</style>", page))
                .containsSubsequence(".wide {", "overflow-x: auto;", "no-repeat local")
                .contains("@media (max-width: 40rem)");
        assertThat(page).contains("<div class=\"wide\"><table>");
    }

    @Test
    void columnsOfWordsAreSet() {
        Table table =
                new Table(
                        List.of("a", "b", "c"),
                        List.of(List.of("1", "left", "below 0.1 %"), List.of("2", "", "9 %")),
                        "");
        assertThat(ReportPage.html(new Report("", "", List.of(Section.of("", table)))))
                .contains("<tr><th>a</th><th class=\"words\">b</th><th>c</th></tr>")
                .contains("<tr><td>2</td><td class=\"words\"></td><td>9 %</td></tr>");
    }

    @Test
    void aRowThatDoesNotFitItsHeaderIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Table(List.of("a"), List.of(List.of("1", "2")), ""))
                .withMessage("a row of 2 cells does not fit a header of 1: [1, 2]");
    }
}
