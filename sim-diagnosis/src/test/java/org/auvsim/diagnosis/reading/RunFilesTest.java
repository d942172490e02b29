package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Several files: which are fitted, held out or a reference. */
class RunFilesTest {
    @TempDir private Path folder;
    private final RunReader reader = Rov.reader(ColumnMapping.USUAL);

    @ParameterizedTest
    @ValueSource(strings = {"dive.csv", "dive.CSV", "dive.Txt", "dive.auvsml.gz", "dive"})
    void aRunIsNamedByItsFileWithoutTheEnding(String file) {
        assertThat(RunReader.nameOf(Path.of("data", file))).isEqualTo("dive");
    }

    private Path run(String name, int seed) throws IOException {
        return Rov.dive(folder.resolve(name + ".csv"), seed);
    }

    private void document(String name, String text) throws IOException {
        Rov.write(folder.resolve(name + ".xml"), text);
    }

    @Test
    void runsAreToldApartAsAsked() throws Exception {
        RunFiles files =
                RunFiles.read(
                        reader, List.of(run("one", 0), run("two", 1)), List.of(run("three", 2)));

        assertThat(files.fit()).extracting(MeasuredRun::name).containsExactly("one", "two");
        assertThat(files.heldOut()).extracting(MeasuredRun::name).containsExactly("three");
        assertThat(files.notices()).isEmpty();
    }

    @Test
    void aMassInGramsIsToldOnce() throws Exception {
        RunReader inGrams = Rov.reader(Rov.SCENARIO.replace("mass=\"30\"", "mass=\"30000\""));

        assertThat(RunFiles.read(inGrams, List.of(run("one", 0)), List.of(run("two", 1))).notices())
                .singleElement()
                .asString()
                .startsWith("the scenario's 'Rov' has a mass of 30000 kg, but a sphere of")
                .contains("no more than 5640 kg: is its mass in g");
    }

    @Test
    void runsToFitAreCutIntoPartsThatShareTheirBorders() throws Exception {
        RunFiles runs = RunFiles.read(reader, List.of(run("one", 0)), List.of(run("two", 5)));
        double whole = runs.fit().getFirst().duration();

        RunFiles parts = runs.inParts(whole / 3);

        assertThat(parts.fit())
                .extracting(MeasuredRun::name)
                .containsExactly("one-1", "one-2", "one-3");
        assertThat(parts.fit().get(1).time(0))
                .isEqualTo(parts.fit().get(0).time(parts.fit().get(0).size() - 1));
        assertThat(parts.fit().stream().mapToDouble(MeasuredRun::duration).sum())
                .isCloseTo(whole, within(1e-9));
        assertThat(parts.heldOut()).isEqualTo(runs.heldOut());
        assertThat(parts.notices().getLast()).startsWith("one: fitted in 3 parts");
        assertThat(runs.inParts(1e-3).fit()).allMatch(part -> part.size() >= 16);
        assertThatThrownBy(() -> runs.inParts(0)).hasMessageContaining("longer than 0 s");
    }

    @Test
    void theDocumentMayGiveTheRole() throws Exception {
        document("two", "<run role=\"HOLDOUT\"/>");

        RunFiles files = RunFiles.read(reader, List.of(run("one", 0), run("two", 1)), List.of());

        assertThat(files.heldOut()).extracting(MeasuredRun::name).containsExactly("two");
        assertThat(files.notices())
                .containsExactly("two: the document beside it says that it is held out");
    }

    @Test
    void withoutARunToHoldOutSomeAre() throws Exception {
        RunFiles files =
                RunFiles.read(
                        reader, List.of(run("one", 0), run("two", 1), run("three", 2)), List.of());

        assertThat(files.fit()).extracting(MeasuredRun::name).containsExactly("one", "two");
        assertThat(files.heldOut()).extracting(MeasuredRun::name).containsExactly("three");
        assertThat(files.notices())
                .containsExactly(
                        "no held-out runs were named, so three is held out and 2 are fitted");
    }

    @Test
    void oneRunThatIsTooShortCannotBeSplit() throws Exception {
        Path file =
                Rov.write(
                        folder.resolve("short.csv"),
                        Rov.rows("x,main,rudder", 20, i -> i + ",0,0"));

        assertThatThrownBy(() -> RunFiles.read(reader, List.of(file), List.of()))
                .isInstanceOf(DocumentException.class)
                .hasMessageStartingWith(file + ": run 'short' has 20 samples; expected 48");
    }

    @Test
    void aFileIsGivenOnce() throws Exception {
        Path one = run("one", 0);
        Path same = folder.resolve(".").resolve("one.csv");

        assertThatThrownBy(() -> RunFiles.read(reader, List.of(one, same), List.of()))
                .hasMessage(one + " is given twice to fit; give each run once");
        assertThatThrownBy(() -> RunFiles.read(reader, List.of(one), List.of(same)))
                .hasMessage(
                        same
                                + " is given to fit and to hold out; what is fitted cannot judge:"
                                + " give another run");
    }

    @Test
    void copiesAreTold() throws Exception {
        Path one = run("one", 0);
        Path copy = run("copy", 0);

        assertThatThrownBy(() -> RunFiles.read(reader, List.of(one), List.of(copy)))
                .hasMessage(
                        copy
                                + ":2: column 'x': rows 2 to 61 have the same numbers as rows 2 to"
                                + " 61 of "
                                + one
                                + "; a copy adds no information and cannot judge: leave one of them"
                                + " out");
    }

    @Test
    void copiesWithinAFileAreTold() throws Exception {
        Path file =
                Rov.write(
                        folder.resolve("runs.csv"),
                        Rov.rows("run,x", 60, i -> i / 20 + "," + i % 40 * (i / 20)));

        assertThatThrownBy(() -> RunFiles.read(reader, List.of(run("one", 1), file), List.of()))
                .hasMessageContaining(
                        "runs.csv:2: column 'x': every measured number of run 'runs' is the same");
        Rov.write(file, Rov.rows("run,x,main,rudder", 60, i -> i / 20 + "," + i % 20 + ",0,0"));
        assertThatThrownBy(() -> RunFiles.read(reader, List.of(run("one", 1), file), List.of()))
                .hasMessageStartingWith(
                        file
                                + ":22: column 'x': rows 22 to 41 have the same numbers as rows 2"
                                + " to 21 of ");
    }

    @Test
    void whatOneRunWasToldIsKnownOfAll() throws Exception {
        Path one = run("one", 0);
        Path other = Rov.write(folder.resolve("other.csv"), Rov.rows("x,main", 60, i -> -i + ",0"));
        String refusal =
                other
                        + ":1: column 'rudder': expected what 'rudder' was told, for "
                        + one
                        + " has it, but the header has no such column; add it, rename the one that"
                        + " has it (--rename COLUMN=rudder), or leave it out of all runs (--ignore"
                        + " rudder)";

        assertThatThrownBy(() -> RunFiles.read(reader, List.of(one), List.of(other)))
                .isInstanceOf(DocumentException.class)
                .hasMessage(refusal);
        assertThatThrownBy(() -> RunFiles.read(reader, List.of(other, one), List.of()))
                .hasMessage(refusal);

        RunReader ignoring =
                Rov.reader(ColumnMapping.USUAL.with(List.of(MappedColumn.ignored("rudder"))));
        assertThat(RunFiles.read(ignoring, List.of(one), List.of(other)).notices())
                .containsExactly(holding(one, "0.0"), holding(other, "0.0"));
    }

    private static String holding(Path file, String angle) {
        return file
                + ":1: column 'rudder': expected the angle of the fin, but the header has no such"
                + " column: it holds the scenario's "
                + angle
                + "; add the column, or rename the one that has it (--rename COLUMN=rudder)";
    }

    /** One file has the old name of a column, another the usual one already. */
    @Test
    void eachFileIsReadWithTheRenamesThatItHasColumnsFor() throws Exception {
        Path old = Rov.write(folder.resolve("old.csv"), Rov.rows("x,psi", 60, i -> i + ",0.5"));
        Path other = Rov.write(folder.resolve("other.csv"), Rov.rows("x,yaw", 60, i -> -i + ",1"));
        RunReader renaming =
                Rov.reader(ColumnMapping.USUAL.with(List.of(MappedColumn.renamed("psi", "yaw"))));

        RunFiles files = RunFiles.read(renaming, List.of(old), List.of(other));

        assertThat(files.fit().getFirst().measures(Channel.ORIENTATION, 2)).isTrue();
        assertThat(files.heldOut().getFirst().measures(Channel.ORIENTATION, 2)).isTrue();
    }

    @Test
    void whatIsRenamedIsInOneFileAtLeast() throws Exception {
        Path one = Rov.write(folder.resolve("one.csv"), Rov.rows("x,yaw", 60, i -> i + ",0.5"));
        Path other = Rov.write(folder.resolve("other.csv"), Rov.rows("x,yaw", 60, i -> -i + ",1"));
        RunReader renaming =
                Rov.reader(ColumnMapping.USUAL.with(List.of(MappedColumn.renamed("psi", "yaw"))));

        assertThatThrownBy(() -> RunFiles.read(renaming, List.of(one), List.of(other)))
                .isInstanceOf(DocumentException.class)
                .hasMessage(
                        one
                                + ":1: column 'psi': it is to be renamed to 'yaw', but none of the"
                                + " 2 files has one of this name; a column has that name"
                                + " already: leave this renaming out");
    }

    @Test
    void somethingIsLeftToFit() throws Exception {
        document("one", "<run role=\"HOLDOUT\"/>");
        Path one = run("one", 0);

        assertThatThrownBy(() -> RunFiles.read(reader, List.of(one), List.of()))
                .hasMessageContaining("are to be held out; expected one to fit at least");
    }

    @Test
    void filesOfOneNameAreToldApart() throws Exception {
        Path other = Files.createDirectory(folder.resolve("other")).resolve("one.csv");
        Rov.write(other, Rov.rows("x,main,rudder", 60, i -> 5 * i + ",0,0"));

        RunFiles files = RunFiles.read(reader, List.of(run("one", 0)), List.of(other));

        assertThat(files.heldOut()).extracting(MeasuredRun::name).containsExactly("one_2");
        assertThat(files.heldOut().getFirst().value(Channel.POSITION, 3, 0)).isEqualTo(15);
    }

    @Test
    void referenceRunsAreBesideTheOthers() throws Exception {
        List<Path> sound = List.of(run("sound", 3), run("healthy", 4));

        RunFiles runs = RunFiles.read(reader, List.of(run("dive", 1)), List.of(run("b", 2)), sound);

        assertThat(runs.reference())
                .extracting(MeasuredRun::name)
                .containsExactly("sound", "healthy");
        assertThat(runs.fit()).extracting(MeasuredRun::name).containsExactly("dive");
        assertThat(runs.inParts(1).reference()).isEqualTo(runs.reference());
        assertThat(runs.fit().getFirst().part("part", 3, 20).part("part", 1, 5).whole())
                .isSameAs(runs.fit().getFirst());
    }

    /** Rows are 0.1 s apart: of the brief one nothing like that stretch is left. */
    @Test
    void ofReferenceRunsAllCounts() throws Exception {
        Path brief =
                Rov.write(
                        folder.resolve("brief.csv"),
                        Rov.rows("x,main,rudder", 20, i -> i + ",0,0"));

        RunFiles runs =
                RunFiles.read(
                        reader.between(1, 4),
                        List.of(run("dive", 1)),
                        List.of(run("b", 2)),
                        List.of(run("sound", 3), brief));

        assertThat(runs.fit().getFirst().size()).isEqualTo(31);
        assertThat(runs.reference()).extracting(MeasuredRun::size).containsExactly(60, 20);
    }

    @Test
    void aReferenceIsNoneOfTheRunsThatAreDiagnosed() throws Exception {
        Path dive = run("dive", 1);
        Path sound = run("sound", 3);
        Path copy = run("copy", 1);

        assertThatThrownBy(
                        () -> RunFiles.read(reader, List.of(dive), List.of(), List.of(sound, dive)))
                .isInstanceOf(DocumentException.class)
                .hasMessage(
                        dive
                                + " is given as a reference and to be diagnosed; no run is its own"
                                + " measure: give another one");
        assertThatThrownBy(
                        () ->
                                RunFiles.read(
                                        reader, List.of(dive), List.of(), List.of(sound, sound)))
                .hasMessage(sound + " is given twice as a reference; give each run once");
        for (RunReader each : List.of(reader, reader.between(1, 4))) {
            assertThatThrownBy(() -> RunFiles.read(each, List.of(dive), List.of(), List.of(copy)))
                    .hasMessageContaining("have the same numbers as rows 2 to 61 of " + dive);
        }
    }

    @Test
    void aMappingIsADocumentOfItsOwn() throws Exception {
        Path mapping =
                Rov.write(
                        folder.resolve("mapping.xml"),
                        """
                        <column-mapping axes="NED" degrees="1">
                          <column name="psi" means="yaw"/>
                          <column name="pwm" means="main" scale="0.0025" offset="-3.75"/>
                          <column name="clock" means="t" form="HHMMSS"/>
                          <column name="volt" ignored="1"/>
                        </column-mapping>
                        """);
        StringBuilder text = new StringBuilder("clock,psi,pwm,volt\n");
        for (int i = 0; i < 20; i++) {
            text.append(100000 + i).append(',').append(i).append(",1900,12\n");
        }
        Path file = Rov.write(folder.resolve("run.csv"), text.toString());

        MeasuredRun run =
                Rov.reader(RunReader.mapping(mapping, Rov.MAPPER)).read(file).runs().getFirst();

        assertThat(run.time(1) - run.time(0)).isEqualTo(1);
        assertThat(run.commands().getFirst().level(3)).isEqualTo(1);
        assertThat(run.orientation(0).orElseThrow().rotate(new Vec3(1, 0, 0)).y())
                .isGreaterThan(0.999);
    }
}
