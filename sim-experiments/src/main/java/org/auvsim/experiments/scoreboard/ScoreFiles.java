package org.auvsim.experiments.scoreboard;

import static java.nio.charset.StandardCharsets.UTF_8;

import de.siegmar.fastcsv.writer.CsvWriter;

import org.auvsim.plot.page.ReportPage;

import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Writes what came of a plan: a row a case, the figures for machines, a page for people. */
public final class ScoreFiles {
    private ScoreFiles() {}

    /**
     * Writes {@code cases.csv}, {@code scores.json} and {@code report.html} into a folder.
     *
     * @throws IOException if that is not possible
     */
    public static void write(Path folder, Plan plan, List<Outcome> outcomes) throws IOException {
        Files.createDirectories(folder);
        cases(folder.resolve("cases.csv"), outcomes);
        List<Scores> scores = Scores.of(plan, outcomes);
        Files.writeString(folder.resolve("scores.json"), json(plan, scores, outcomes));
        ReportPage.write(folder, ScoreReport.of(plan, scores, outcomes));
    }

    private static void cases(Path file, List<Outcome> outcomes) throws IOException {
        try (CsvWriter csv = CsvWriter.builder().build(file, UTF_8)) {
            csv.writeRecord(
                    "method",
                    "kind",
                    "noise",
                    "seed",
                    "body",
                    "hidden",
                    "verdict",
                    "selected",
                    "right",
                    "error_left",
                    "baseline",
                    "seconds",
                    "repeat");
            for (Outcome o : outcomes) {
                csv.writeRecord(
                        o.method().toString(),
                        o.kind().toString(),
                        Double.toString(o.noise()),
                        Long.toString(o.seed()),
                        o.body(),
                        String.join(" + ", o.hidden()),
                        o.said().verdict().name(),
                        String.join(" + ", o.said().causes()),
                        Boolean.toString(o.isRight()),
                        Double.toString(o.errorLeft()),
                        String.join(" + ", o.baseline()),
                        Double.toString(o.seconds()),
                        o.repeat());
            }
        }
    }

    private static String json(Plan plan, List<Scores> scores, List<Outcome> outcomes) {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("seed", plan.seed());
        all.put("cases", plan.cases());
        all.put("complete", plan.shortfall(outcomes.size()).isEmpty());
        all.put("diagnoses", plan.drawings().size());
        all.put("judged", outcomes.size());
        List<Map<String, Object>> byNoise = new ArrayList<>();
        for (Scores at : scores) {
            Map<String, Object> figures = new LinkedHashMap<>();
            figures.put("noise", at.noise());
            figures.put("method", at.method().toString());
            figures.put("judged", outcomes.stream().filter(at::counts).count());
            for (Figure figure : Figure.values()) {
                figures.put(figure.key(), figure.forMachines(at));
            }
            byNoise.add(figures);
        }
        all.put("noises", byNoise);
        return JsonMapper.builder()
                        .enable(SerializationFeature.INDENT_OUTPUT)
                        .build()
                        .writeValueAsString(all)
                + "\n";
    }
}
