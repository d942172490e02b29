package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.diagnosis.model.BelievedModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Collectors;

/** Positions of which some are told in a unit that is off by 1000, and others that only look so. */
class UnitsTest {
    private static final Path EXAMPLES = Path.of("..", "examples", "diagnosis");

    /** A vehicle that is pushed ahead and down; its drag is 30 % less than that of the true one. */
    private static final String VEHICLE =
            """
            <scenario>
              <time-step delta="0.1"/>
              <world-object id="1" name="Rov" mass="30">
                <box><size x="0.6" y="0.4" z="0.3"/></box>
                <damping><quadratic x="28" y="28" z="70"/></damping>
                <propulsor name="main" maximum-thrust="20"/>
                <propulsor name="lift" maximum-thrust="20"><direction x="0" y="0" z="1"/></propulsor>
              </world-object>
            </scenario>
            """;

    @TempDir private Path folder;

    /** Factors of what is told, beside metres. */
    private record Told(double x, double y, double z, double vx, double vz) {
        static final Told RIGHT = new Told(1, 1, 1, 1, 1);
    }

    private static BelievedModel model(String scenario) {
        return new BelievedModel(parsed(scenario), "Rov");
    }

    private static Scenario parsed(String scenario) {
        try {
            return ScenarioLoader.load(Rov.LOADER).parse(scenario.getBytes(UTF_8));
        } catch (AuvsmlException e) {
            throw new IllegalStateException(e);
        }
    }

    private List<String> suspicions(String header, String rows) throws Exception {
        return suspicions(VEHICLE, header, rows);
    }

    private List<String> suspicions(String scenario, String header, String rows) throws Exception {
        Path file = Rov.write(folder.resolve("run.csv"), header + "\n" + rows);
        return new RunReader(model(scenario), ColumnMapping.USUAL, Rov.MAPPER)
                .read(file).notices().stream()
                        .filter(notice -> !notice.contains("expected "))
                        .filter(notice -> !notice.contains("no column gives the commands"))
                        .map(notice -> notice.replace(file.toString(), "run.csv"))
                        .toList();
    }

    /** 20 s of the true vehicle, ten rows a second, with 5 mm and 5 mm/s of noise. */
    private static String dive(Told told, boolean hasVelocities) {
        Random lot = new Random(3);
        StringBuilder rows = new StringBuilder();
        double x = 0;
        double z = -1;
        double vx = 0.3;
        double vz = 0;
        for (int i = 0; i <= 200; i++) {
            double main = i < 70 ? 0.8 : i < 130 ? -0.2 : 0.5;
            double lift = i < 50 ? -0.5 : i < 100 ? 0.3 : -0.1;
            rows.append(
                    String.format(
                            Locale.ROOT,
                            "%.1f,%.6f,%.6f,%.6f,%s,%s",
                            0.1 * i,
                            told.x * (x + lot.nextGaussian(0, 0.005)),
                            told.y * lot.nextGaussian(0, 0.005),
                            told.z * (z + lot.nextGaussian(0, 0.005)),
                            main,
                            lift));
            if (hasVelocities) {
                rows.append(
                        String.format(
                                Locale.ROOT,
                                ",%.7f,0,%.7f",
                                told.vx * (vx + lot.nextGaussian(0, 0.005)),
                                told.vz * (vz + lot.nextGaussian(0, 0.005))));
            }
            rows.append('\n');
            for (int step = 0; step < 10; step++) {
                vx += 0.01 * (20 * main - 40 * vx * Math.abs(vx)) / 30;
                vz += 0.01 * (20 * lift - 100 * vz * Math.abs(vz)) / 30;
                x += 0.01 * vx;
                z += 0.01 * vz;
            }
        }
        return rows.toString();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void metresAreNotSuspected(boolean hasVelocities) throws Exception {
        String header = "t,x,y,z,main,lift" + (hasVelocities ? ",vx,vy,vz" : "");

        assertThat(suspicions(header, dive(Told.RIGHT, hasVelocities))).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "1000,  1000,  1000,  'columns ''x'', ''z''', less far, mm, 0.001",
        "0.001, 0.001, 0.001, 'columns ''x'', ''z''', as far,   km, 1000",
        "1,     1,     1000,  'column ''z''',         less far, mm, 0.001",
        "1,     1,     0.001, 'column ''z''',         as far,   km, 1000",
        "1000,  1000,  1,     'column ''x''',         less far, mm, 0.001",
    })
    void anotherUnitIsSuspectedByHowTheModelMoves(
            double x, double y, double z, String columns, String far, String unit, String scale)
            throws Exception {
        assertThat(suspicions("t,x,y,z,main,lift", dive(new Told(x, y, z, 1, 1), false)))
                .containsExactly(
                        "run.csv:2: %s: the model moves as this does, but 1000 times %s: are these positions in %s? If so, map them with a scale of %s (--mapping, which is for all runs; if it is this one alone, in its file)"
                                .formatted(columns, far, unit, scale));
    }

    /** Its model lacks a force, so that it does not bend as measured in any unit. */
    @Test
    void whatGoesTooFastForAnyVehicleIsSuspectedWhateverTheModelDoes() throws Exception {
        List<String> lines = Files.readAllLines(EXAMPLES.resolve("run1.csv"));
        String rows =
                lines.stream()
                        .skip(1)
                        .map(UnitsTest::inMillimetres)
                        .collect(Collectors.joining("\n"));
        String model = Files.readString(EXAMPLES.resolve("model.xml")).replace("Surveyor", "Rov");

        assertThat(suspicions(model, lines.getFirst(), rows))
                .singleElement()
                .asString()
                .startsWith("run.csv:2: columns 'x', 'y', 'z': the body goes 560 m/s on average")
                .contains("are these positions in mm?");
    }

    private static String inMillimetres(String row) {
        String[] cells = row.split(",", -1);
        for (int i = 1; i <= 3; i++) {
            cells[i] = String.valueOf(1000 * Double.parseDouble(cells[i]));
        }
        return String.join(",", cells);
    }

    @Test
    void aDepthInMillimetresIsSuspected() throws Exception {
        String rows = dive(new Told(1, 1, -1000, 1, 1), false);

        assertThat(suspicions("t,x,y,depth,main,lift", rows))
                .singleElement()
                .asString()
                .startsWith("run.csv:2: column 'depth': the model moves")
                .contains("in mm");
    }

    @ParameterizedTest
    @CsvSource({
        "1, 1,     1000,  1,     'columns ''x'', ''vx''', 0.001",
        "1, 1,     1,     1000,  'columns ''z'', ''vz''', 0.001",
        "1, 1,     0.001, 0.001, 'columns ''x'', ''z'', ''vx'', ''vz''', 1000",
    })
    void velocitiesInAnotherUnitThanPositionsAreSuspected(
            double x, double z, double vx, double vz, String columns, String ratio)
            throws Exception {
        assertThat(suspicions("t,x,y,z,main,lift,vx,vy,vz", dive(new Told(x, x, z, vx, vz), true)))
                .singleElement()
                .asString()
                .matches(
                        "run.csv:2: %s: positions go (1000|0.001|990|1010|0.00099|0.00101) times as far .*"
                                .formatted(columns));
    }

    /** What noise there is of a height that does not change goes far beside a velocity of 0. */
    @Test
    void noiseIsNoOtherUnit() throws Exception {
        Random lot = new Random(5);
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < 200; i++) {
            double noise = lot.nextGaussian(0, 0.02);
            double still = lot.nextGaussian(0, 1e-5);
            rows.append("%s,%s,%s,%s%n".formatted(0.1 * i, 0.05 * i, noise, still));
        }

        assertThat(suspicions("t,x,z,vz", rows.toString())).isEmpty();
    }

    /** It hovers, and the model, which lacks the buoyancy, falls a thousand times as far. */
    @Test
    void aModelThatLacksAForceIsNoOtherUnit() throws Exception {
        String falling =
                VEHICLE.replace("<propulsor name=\"main\"", "<gravity/><propulsor name=\"main\"");
        Random lot = new Random(6);
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < 200; i++) {
            double drift = 0.002 * i + lot.nextGaussian(0, 0.002);
            rows.append("%s,%s,%s%n".formatted(0.1 * i, drift, -5 - drift));
        }

        assertThat(suspicions(falling, "t,x,z", rows.toString())).isEmpty();
    }

    @Test
    void theExampleIsInMetres() throws Exception {
        BelievedModel model =
                new BelievedModel(
                        ScenarioLoader.load(Rov.LOADER).load(EXAMPLES.resolve("model.xml")),
                        "Surveyor");
        RunReader reader = new RunReader(model, ColumnMapping.USUAL, Rov.MAPPER);

        for (String run : List.of("run1.csv", "run2.csv", "run3.csv")) {
            assertThat(reader.read(EXAMPLES.resolve(run)).notices()).isEmpty();
        }
    }
}
