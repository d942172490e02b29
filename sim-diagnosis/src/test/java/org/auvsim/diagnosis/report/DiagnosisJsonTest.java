package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.networknt.schema.Error;
import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;

import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;

import org.auvsim.core.math.Quat;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.PushedSphere;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shaking.Imbalance;
import org.auvsim.diagnosis.shaking.Shaking;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

class DiagnosisJsonTest {
    private static final Path SCHEMA = Path.of("../docs/diagnosis.schema.json");

    private static String json(Diagnosis diagnosis) {
        return DiagnosisJson.text(diagnosis, NamedRun.of(diagnosis.runs()));
    }

    private static List<String> faults(String json) throws IOException {
        Schema schema =
                SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                        .getSchema(Files.readString(SCHEMA), InputFormat.JSON);
        return schema.validate(json, InputFormat.JSON).stream().map(Error::toString).toList();
    }

    private static Stream<Diagnosis> diagnoses() {
        return Stream.of(
                Diagnoses.none(),
                Diagnoses.unexplained(),
                Imbalance.judged(Diagnoses.none(), new Shaking(3.12, 0.48, 2.6, 4, 8, 1)),
                Diagnoses.explained(
                        List.of(Diagnoses.QUADRATIC_DRAG, Diagnoses.THRUST, Diagnoses.CURRENT),
                        100,
                        List.of(new Alternative(List.of("mass_error"), true, "mass / gain", ""))));
    }

    @ParameterizedTest
    @MethodSource("diagnoses")
    void hasTheFormOfItsSchema(Diagnosis diagnosis) throws IOException {
        assertThat(faults(json(diagnosis))).isEmpty();
    }

    /** What a search made, with all that it fills in. */
    @Test
    void whatASearchSaysHasItToo() throws IOException {
        PushedSphere sphere =
                new PushedSphere((_, v) -> new double[] {-8 * v[0], -8 * v[1], -8 * v[2]});

        String json = json(sphere.investigation(1, Set.of("linear_drag")).diagnose());

        assertThat(json).contains("\"verdict\" : \"explained\"");
        assertThat(faults(json)).isEmpty();
    }

    /** A run whose x is far off in a few rows. */
    private static MeasuredRun astray(MeasuredRun of) {
        MeasuredRunBuilder run =
                MeasuredRun.named(of.name())
                        .commands(of.commands().stream().map(Command::name).toList());
        for (int k = 0; k < of.size(); k++) {
            double off = k % 60 == 30 ? 0.1 : 0;
            run.at(of.time(k)).orientation(Quat.IDENTITY);
            run.position(
                    of.value(Channel.POSITION, k, 0) + off,
                    of.value(Channel.POSITION, k, 1),
                    of.value(Channel.POSITION, k, 2));
            for (int c = 0; c < of.commands().size(); c++) {
                run.command(c, of.commands().get(c).level(k));
            }
        }
        return run.build();
    }

    /** Of the position, with what was found. */
    private static double rootMeanSquare(Path residuals) throws IOException {
        double sum = 0;
        int count = 0;
        for (NamedCsvRecord row : CsvReader.builder().ofNamedCsvRecord(residuals)) {
            for (String axis : List.of("x", "y", "z")) {
                String of = "position." + axis;
                if (!List.of(row.getField("left_out").split(" ", -1)).contains(of)) {
                    sum += Math.pow(Double.parseDouble(row.getField(of + ".after")), 2);
                    count++;
                }
            }
        }
        return Math.sqrt(sum / count);
    }

    /** The same number in each place, which anyone can reckon. */
    @Test
    void errorsOfHeldOutRunsAreThoseOfTheirTables(@TempDir Path folder) throws IOException {
        PushedSphere sphere =
                new PushedSphere((_, v) -> new double[] {-8 * v[0], -8 * v[1], -8 * v[2]});
        BelievedModel model = PushedSphere.model();
        List<MeasuredRun> fit = List.of(sphere.run(1), sphere.run(2));
        List<Cause> causes = Library.named(List.of("linear_drag"), Library.of(model, fit));
        Report.write(
                new Investigation(
                                model,
                                fit,
                                List.of(astray(sphere.run(3))),
                                causes,
                                1,
                                Progress.SILENT)
                        .diagnose(),
                folder);

        JsonNode root = JsonMapper.shared().readTree(folder.resolve("diagnosis.json"));

        double told = root.at("/heldout_rmse_after").asDouble();
        assertThat(told).isBetween(0.0015, 0.0025);
        assertThat(root.at("/runs/2/errors/position/after").asDouble())
                .isCloseTo(told, within(1e-9));
        assertThat(rootMeanSquare(folder.resolve(root.at("/runs/2/residuals").asString())))
                .isCloseTo(told, within(1e-9));
        assertThat(root.at("/runs/2/errors").propertyNames()).containsExactly("position");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"verdict\" : \"none\" -> \"verdict\" : \"perhaps\"",
                "\"seed\" : 42 -> \"seed\" : 4.5",
                "\"sentence\" -> \"statement\"",
                "\"log_evidence\" : -1234.5 -> \"log_evidence\" : \"much\"",
                "\"candidates\" : 62 -> \"candidates\" : -1",
                "\"complete\" : true -> \"complete\" : 1",
                "\"heldout\" : true -> \"held_out\" : true",
            })
    void theSchemaRefusesAnotherForm(String change) throws IOException {
        String[] parts = change.split(" -> ", -1);
        String json = json(Diagnoses.none());
        assertThat(json).contains(parts[0]);
        assertThat(faults(json.replace(parts[0], parts[1]))).isNotEmpty();
    }

    @Test
    void beginsWithTheMembersInTheirOrder() {
        JsonNode root = JsonMapper.shared().readTree(json(Diagnoses.explained()));
        assertThat(root.propertyNames())
                .startsWith(
                        "verdict",
                        "selected",
                        "ranked",
                        "alternatives",
                        "noise",
                        "heldout_rmse_before",
                        "heldout_rmse_after",
                        "heldout",
                        "next_experiment",
                        "seed",
                        "version",
                        "sentence");
    }

    @Test
    void namesCausesWithTheirNumbers() {
        JsonNode root =
                JsonMapper.shared()
                        .readTree(
                                json(
                                        Diagnoses.explained(
                                                List.of(
                                                        Diagnoses.QUADRATIC_DRAG,
                                                        Diagnoses.THRUST,
                                                        Diagnoses.CURRENT),
                                                100,
                                                List.of())));
        assertThat(root.at("/selected/0").toString())
                .isEqualTo(
                        "{\"name\":\"quadratic_drag\",\"params\":{\"k\":12.43},"
                                + "\"sigma\":{\"k\":0.31},\"unit\":{\"k\":\"kg/m\"},"
                                + "\"share\":0.991}");
        assertThat(root.at("/selected/1/params").toString())
                .isEqualTo("{\"thruster\":\"port\",\"factor\":0.8}");
        assertThat(root.at("/selected/2/params").toString()).isEqualTo("{\"u\":[0.2,-0.1,0.0]}");
        assertThat(root.at("/ranked/0/name").asString())
                .isEqualTo("quadratic_drag + thruster_gain (port) + current_constant");
        assertThat(root.at("/candidates").asInt()).isEqualTo(62);
        assertThat(root.at("/heldout_rmse_before").asDouble()).isEqualTo(0.834);
        assertThat(root.at("/heldout/orientation/after").asDouble()).isEqualTo(0.00405);
    }

    /** A body that is held in depth shows no current along z. */
    @Test
    void whatTheDataDoesNotDetermineHasNoSigma() throws IOException {
        Finding current =
                new Finding(
                        Diagnoses.CURRENT.cause(),
                        Optional.empty(),
                        Diagnoses.CURRENT.quantities(),
                        List.of(0.004, 0.003, 3.5e10),
                        0.2,
                        true);

        String json = json(Diagnoses.explained(List.of(current), 100, List.of()));

        assertThat(JsonMapper.shared().readTree(json).at("/selected/0/sigma").toString())
                .isEqualTo("{\"u\":[0.004,0.003,null]}");
        assertThat(faults(json)).isEmpty();
    }

    @Test
    void whatExplainsNothingIsNoFinding() {
        JsonNode root = JsonMapper.shared().readTree(json(Diagnoses.unexplained()));
        assertThat(root.at("/selected").isEmpty()).isTrue();
        assertThat(root.at("/discrepancy/frame").asString()).isEqualTo("world");
        assertThat(root.at("/discrepancy/place").toString()).isEqualTo("[3.21,-0.5,2.0]");
        assertThat(root.at("/approximation/causes/0/name").asString()).isEqualTo("quadratic_drag");
        assertThat(root.at("/approximation/causes/0/sigma").isEmpty()).isTrue();
        assertThat(root.at("/approximation/scenario").asString())
                .isEqualTo("approximate-scenario.xml");
    }

    @Test
    void whatIsNotFiniteIsNull() {
        JsonNode root = JsonMapper.shared().readTree(json(Diagnoses.none()));
        assertThat(root.at("/ranked/2/log_evidence").isNull()).isTrue();
        assertThat(root.at("/ranked/0/name").asString()).isEqualTo("none");
    }

    @Test
    void whereAModelGetsLostItsErrorIsNull() throws IOException {
        String json = json(Diagnoses.lost(Diagnoses.explained()));
        assertThat(JsonMapper.shared().readTree(json).at("/horizons/1/errors/position").toString())
                .isEqualTo("{\"before\":null,\"after\":0.0112,\"noise\":0.01}");
        assertThat(faults(json)).isEmpty();
    }

    @Test
    void runsHaveTheirErrorsAndTables() {
        JsonNode root = JsonMapper.shared().readTree(json(Diagnoses.explained()));
        JsonNode heldOut = root.at("/runs/2");
        assertThat(heldOut.at("/prediction").asString()).isEqualTo("predictions/run3.csv");
        assertThat(heldOut.at("/residuals").asString()).isEqualTo("residuals/run3.csv");
        assertThat(heldOut.at("/errors/position/after").asDouble()).isBetween(0.0095, 0.0105);
        assertThat(heldOut.at("/errors/orientation/after").asDouble()).isBetween(0.0038, 0.0042);
        assertThat(heldOut.at("/errors/position/before").asDouble()).isGreaterThan(1);
        assertThat(root.at("/runs/0/prediction").isNull()).isTrue();
    }
}
