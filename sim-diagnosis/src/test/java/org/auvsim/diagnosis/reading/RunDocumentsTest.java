package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.ScheduledForce;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The documents beside runs. */
class RunDocumentsTest {
    @TempDir private Path folder;
    private final RunReader reader = Rov.reader(ColumnMapping.USUAL);

    private Path run(String name, int seed) throws IOException {
        return Rov.dive(folder.resolve(name + ".csv"), seed);
    }

    private void document(String name, String text) throws IOException {
        Rov.write(folder.resolve(name + ".xml"), text);
    }

    @Test
    void theDocumentBesideARunSaysWhatItsRowsDoNot() throws Exception {
        Path file = run("dive", 0);
        document(
                "dive",
                """
                <run>
                  <start>
                    <position x="1" y="2" z="3" deviation="0.1"/>
                    <orientation w="2" x="0" y="0" z="0" deviation="0.2"/>
                    <angular-velocity x="4" y="5" z="6" deviation="0.3"/>
                  </start>
                  <scheduled-force name="tow" from="1" until="2.5" frame="BODY">
                    <vector x="7" y="0" z="0"/><point x="0" y="0.1" z="0"/>
                  </scheduled-force>
                  <differences mass="-0.5">
                    <gravity/>
                    <uniform-current id="7" name="ebb"><velocity x="0.3" y="0" z="0"/></uniform-current>
                  </differences>
                </run>
                """);

        MeasuredRun run = reader.read(file).runs().getFirst();

        KnownStart start = run.start().orElseThrow();
        assertThat(start.motion().position()).isEqualTo(new Vec3(1, 2, 3));
        assertThat(start.motion().orientation().w()).isEqualTo(1);
        double never = Double.POSITIVE_INFINITY;
        assertThat(start.deviations())
                .containsExactly(0.1, 0.1, 0.1, 0.2, 0.2, 0.2, never, never, never, 0.3, 0.3, 0.3);
        ScheduledForce tow = run.forces().getFirst();
        assertThat(tow.from()).isEqualTo(1);
        assertThat(tow.until()).isEqualTo(2.5);
        assertThat(tow.force().frame()).isEqualTo(Frame.BODY);
        assertThat(tow.force().point()).isEqualTo(new Vec3(0, 0.1, 0));
        assertThat(run.differences().mass()).isEqualTo(-0.5);
        assertThat(run.differences().effects()).hasOnlyElementsOfType(Gravity.class);
        assertThat(run.differences().currents()).extracting(c -> c.name()).containsExactly("ebb");
    }

    /** Rows are 0.1 s apart. */
    @Test
    void ofEachRunOnlyAStretchMayCount() throws Exception {
        Path one = run("one", 0);
        Path other = run("other", 100);

        RunFiles runs = RunFiles.read(reader.between(1, 4), List.of(one), List.of(other));

        MeasuredRun run = runs.fit().getFirst();
        MeasuredRun whole = reader.read(one).runs().getFirst();
        assertThat(run.size()).isEqualTo(31);
        assertThat(run.time(0)).isEqualTo(whole.time(10));
        assertThat(run.time(30)).isEqualTo(whole.time(40));
        assertThat(run.value(Channel.POSITION, 0, 0)).isEqualTo(10);
        assertThat(runs.heldOut().getFirst().size()).isEqualTo(31);
    }

    @Test
    void whatIsKnownOfARunsStartGoesWithItsFirstRow() throws Exception {
        Path file = run("dive", 0);
        document(
                "dive",
                "<run><start><position x=\"1\" y=\"2\" z=\"3\" deviation=\"0.1\"/></start></run>");

        assertThat(reader.between(0, 4).read(file).runs().getFirst().start()).isPresent();
        assertThat(reader.between(1, 4).read(file).runs().getFirst().start()).isEmpty();
    }

    @Test
    void aStretchOfWhichARunHasTooLittleIsRefused() throws Exception {
        Path file = run("dive", 0);

        assertThatThrownBy(() -> reader.between(5, 60).read(file))
                .isInstanceOf(DocumentException.class)
                .hasMessage(
                        file
                                + ":2: run 'dive' has 10 rows from 5 s after its first row until 60"
                                + " s after it, of its 5.9 s; expected 16 at least: take more of"
                                + " it");
        assertThatThrownBy(() -> reader.between(5, Double.POSITIVE_INFINITY).read(file))
                .hasMessageContaining("has 10 rows from 5 s after its first row to its end, of");
        assertThatThrownBy(() -> reader.between(4, 4))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("until 4 s");
    }

    @Test
    void aWrongDocumentIsToldWithItsPlace() throws Exception {
        Path file = run("dive", 0);
        document("dive", "<run>\n  <start><position x=\"1\" y=\"0\" z=\"0\"/></start>\n</run>");

        assertThatThrownBy(() -> reader.read(file))
                .isInstanceOf(DocumentException.class)
                .hasMessageStartingWith(folder.resolve("dive.xml") + ":2:")
                .hasMessageContaining("deviation");
    }

    @Test
    void whatARunHadLessOfLeavesSomeMass() throws Exception {
        Path file = run("dive", 0);
        document("dive", "<run><differences mass=\"-30\"/></run>");

        assertThatThrownBy(() -> reader.read(file))
                .isInstanceOf(DocumentException.class)
                .hasMessage(
                        folder.resolve("dive.xml")
                                + ": differences: mass is -30 kg, which leaves 'Rov' nothing of its"
                                + " 30 kg; expected how many kg more, or less, it had than in the"
                                + " scenario");
    }

    @Test
    void aRunsOwnFieldsAreCurrents() throws Exception {
        Path file = run("dive", 0);
        document(
                "dive",
                """
                <run><differences>
                  <uniform-magnetic-field id="7" name="earth"><flux-density x="0" y="2e-5" z="-4e-5"/>
                  </uniform-magnetic-field>
                </differences></run>
                """);

        assertThatThrownBy(() -> reader.read(file))
                .isInstanceOf(DocumentException.class)
                .hasMessageContaining("a run's own fields must be currents, but 'earth' is none");
    }

    @Test
    void aRunsOwnCurrentIsAnotherThanThoseOfTheScenario() throws Exception {
        Path file = run("dive", 0);
        document(
                "dive",
                """
                <run><differences>
                  <uniform-current id="70" name="ebb"><velocity x="1" y="0" z="0"/></uniform-current>
                </differences></run>
                """);

        assertThatThrownBy(() -> reader.read(file))
                .hasMessage(
                        folder.resolve("dive.xml")
                                + ": the current 'ebb' (id 70) has the id or the name of the"
                                + " scenario's 'Tide' (id 70); give it others");
    }

    @Test
    void aScenarioBesideARunSaysNothingOfIt() throws Exception {
        Path file = run("dive", 0);
        document("dive", Rov.SCENARIO);

        assertThat(reader.read(file).notices())
                .containsExactly(
                        "%s: is a scenario, and says nothing of the run 'dive' beside it"
                                .formatted(folder.resolve("dive.xml")));
    }

    @Test
    void aForceIsToldByColumnsOrByADocument() throws Exception {
        Path one =
                Rov.write(
                        folder.resolve("one.csv"),
                        Rov.rows("x,push,main,rudder", 60, i -> i + ",3,0,0"));
        Path other = run("other", 5);

        assertThatThrownBy(() -> RunFiles.read(reader, List.of(one), List.of(other)))
                .hasMessageStartingWith(
                        other + ":1: column 'push': expected what 'push.x' was told, for " + one);

        document(
                "other",
                """
                <run><scheduled-force name="push" from="1" until="2"><vector x="1" y="0" z="0"/>
                </scheduled-force></run>
                """);
        assertThat(RunFiles.read(reader, List.of(one), List.of(other)).heldOut()).hasSize(1);
    }

    /** Where capitals make no other file, the document is read. */
    @Test
    void aDocumentWhoseNameDiffersByCapitalsIsTold() throws Exception {
        Path file = run("dive", 0);
        document("Dive", "<run role=\"holdout\"/>");
        boolean isOther = !Files.exists(folder.resolve("dive.xml"));

        assertThat(reader.read(file).notices())
                .filteredOn(notice -> notice.contains("Dive.xml: is not read: a document"))
                .hasSize(isOther ? 1 : 0);
    }

    /** Rows are from 0 to 5.9 s, and x goes from 0 to 59 m. */
    @Test
    void whatADocumentStatesOfAnotherRunIsTold() throws Exception {
        Path file = run("dive", 0);
        document(
                "dive",
                """
                <run>
                  <start>
                    <position x="1200" y="0" z="0" deviation="5"/>
                    <velocity x="900" y="0" z="0" deviation="5"/>
                  </start>
                  <scheduled-force name="tow" from="5.9" until="7"><vector x="1" y="0" z="0"/>
                  </scheduled-force>
                  <scheduled-force name="pull" from="5.8" until="7"><vector x="1" y="0" z="0"/>
                  </scheduled-force>
                </run>
                """);
        Path document = folder.resolve("dive.xml");

        assertThat(reader.read(file).notices())
                .containsExactly(
                        document
                                + ": scheduled-force 'tow': acts from 5.9 s until 7 s, but the rows"
                                + " of "
                                + file
                                + " are from 0 s until 5.9 s, so that it does nothing; state its"
                                + " times by the rows' clock",
                        document
                                + ": start/position: x is 1200 m, but "
                                + file
                                + ":2: column 'x': the first that is measured is 0 m, and all of"
                                + " the run is within 59 m: is it the start of another run, or in"
                                + " other axes?");

        document(
                "dive",
                "<run><start><position x=\"200\" y=\"0\" z=\"0\" deviation=\"5\"/></start></run>");
        assertThat(reader.read(file).notices()).isEmpty();
    }
}
