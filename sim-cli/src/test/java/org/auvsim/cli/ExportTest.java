package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.control.StepCommand;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.movement.CollisionNotification;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.recording.ClientCame;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.ClientWent;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

class ExportTest {
    private static final AuvsmlMapper MAPPER = AuvsmlMapper.load(ExportTest.class.getClassLoader());

    @TempDir private Path folder;
    private CommandLineHarness auvsim;
    private Path file;

    @BeforeEach
    void record() throws Exception {
        auvsim = new CommandLineHarness(folder);
        file = folder.resolve("run.auvsml.gz");
        Scenario scenario =
                ScenarioLoader.load(ExportTest.class.getClassLoader())
                        .parse("<scenario/>".getBytes(UTF_8));
        try (RecordingWriter writer = new RecordingWriter(Files.newOutputStream(file), MAPPER)) {
            writer.begin(new Recording(Recording.VERSION, "auvsim", 20), scenario);
            for (Entry entry : entries()) {
                writer.write(entry);
                writer.flush();
            }
        }
    }

    private static List<Entry> entries() {
        return List.of(
                new Happened(
                        0,
                        0,
                        0,
                        List.of(
                                new WorldObjectListResponse(
                                        List.of(
                                                new ListedWorldObject(1, "WorldObject", "AUV, old"),
                                                new ListedWorldObject(2, "WorldObject", "Rock"))),
                                movement(0, new Vec3(1, 2, 3)))),
                new ClientCame(0, 0, 0, false, 0, 7, "127.0.0.1:5000", Role.ADMIN),
                new ClientSent(
                        0,
                        0,
                        1,
                        true,
                        0,
                        7,
                        Optional.of("r1"),
                        List.of(
                                new StepCommand(3),
                                new DifferentPositionFeedbackMessage(
                                        1,
                                        0.5,
                                        "DirectPositionChangeFeedbackHandler",
                                        new Vec3(9, 9, 9),
                                        new Vec3(1, 2, 4),
                                        new Vec3(8, 8, 8)))),
                new Happened(
                        0,
                        1,
                        0.5,
                        List.of(
                                new CollisionNotification(
                                        0.25,
                                        1,
                                        2,
                                        new Vec3(1, 0, 0),
                                        new Vec3(0, 0, 1),
                                        new Vec3(0, 0, 5)),
                                movement(0.5, new Vec3(1, 2, 4)))),
                new ClientWent(0, 1, 0, false, 0.5, 7),
                new RecordingEnded(0, 1, 0.5, "the simulation has ended"));
    }

    private static MovementStateChangeMessage movement(double time, Vec3 position) {
        return new MovementStateChangeMessage(
                time,
                1,
                false,
                position,
                Quat.IDENTITY.toMatrix(),
                new Vec3(10, 20, 30),
                new Vec3(-1, 0, 1));
    }

    @Test
    void writesAFileForEachTable() throws IOException {
        Path out = folder.resolve("tables");

        assertThat(export("csv", out)).as(auvsim.err()).isZero();

        assertThat(Files.readAllLines(out.resolve("movements.csv")))
                .containsExactly(
                        "revision,step,t,id,name,x,y,z,qw,qx,qy,qz,px,py,pz,lx,ly,lz",
                        "0,0,0.0,1,\"AUV,"
                                + " old\",1.0,2.0,3.0,1.0,0.0,0.0,0.0,10.0,20.0,30.0,-1.0,0.0,1.0",
                        "0,1,0.5,1,\"AUV,"
                                + " old\",1.0,2.0,4.0,1.0,0.0,0.0,0.0,10.0,20.0,30.0,-1.0,0.0,1.0");
        assertThat(Files.readAllLines(out.resolve("collisions.csv")))
                .element(1)
                .isEqualTo("0,1,0.25,1,\"AUV, old\",2,Rock,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,5.0");
        assertThat(Files.readAllLines(out.resolve("feedback.csv")))
                .element(1)
                .isEqualTo(
                        "0,1,1,0.0,7,1,\"AUV, old\",different-position-feedback-message,0.5,"
                            + "DirectPositionChangeFeedbackHandler,world,1.0,2.0,4.0,,,,,,,,,,");
        assertThat(Files.readAllLines(out.resolve("messages.csv")))
                .hasSize(3)
                .element(1)
                .isEqualTo("0,1,1,0.0,7,r1,step-command,\"<step-command count=\"\"3\"\"/>\"");
        assertThat(Files.readAllLines(out.resolve("sessions.csv")))
                .containsExactly(
                        "step,input,during_step,t,session,event,peer,role",
                        "0,0,0,0.0,7,came,127.0.0.1:5000,admin",
                        "1,0,0,0.5,7,went,,");
        assertThat(auvsim.out())
                .isEqualTo(
                        "movements: 2, collisions: 1, feedback: 1, messages: 2, sessions: 2 written"
                                + " to %s\n".formatted(out));
    }

    @Test
    void writesADatabaseOfTheSameTables() throws Exception {
        Path out = folder.resolve("run.db");

        assertThat(export("sqlite", out)).as(auvsim.err()).isZero();

        assertThat(query(out, "SELECT name, z, px FROM movements WHERE t > 0"))
                .containsExactly("AUV, old|4.0|10.0");
        assertThat(query(out, "SELECT z, qw IS NULL, typeof(id), handler FROM feedback"))
                .containsExactly("4.0|1|integer|DirectPositionChangeFeedbackHandler");
        assertThat(
                        query(
                                out,
                                "SELECT m.kind, s.peer FROM messages m JOIN sessions s ON"
                                        + " m.session = s.session AND s.event = 'came'"))
                .containsExactlyInAnyOrder(
                        "step-command|127.0.0.1:5000",
                        "different-position-feedback-message|127.0.0.1:5000");
        assertThat(query(out, "SELECT count(*), impulse_z FROM collisions"))
                .containsExactly("1|5.0");
    }

    private static List<String> query(Path database, String sql) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + database);
                Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(sql)) {
            List<String> found = new ArrayList<>();
            while (rows.next()) {
                List<String> cells = new ArrayList<>();
                for (int i = 1; i <= rows.getMetaData().getColumnCount(); i++) {
                    cells.add(String.valueOf(rows.getString(i)));
                }
                found.add(String.join("|", cells));
            }
            return found;
        }
    }

    @ParameterizedTest
    @CsvSource({"csv, tables, tables/movements.csv", "sqlite, run.db, run.db"})
    void filesThatAreThereAreLeftAloneUnlessForced(String format, String name, String existing)
            throws IOException {
        Path out = folder.resolve(name);
        Path there = folder.resolve(existing);
        Files.createDirectories(there.getParent());
        Files.writeString(there, "mine");

        assertThat(export(format, out)).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        there
                                + " exists; name another place by --out, or write over it with"
                                + " --force.\n");
        assertThat(there).hasContent("mine");

        assertThat(auvsim.run("export", file, "--format", format, "--out", out, "--force"))
                .isZero();
        assertThat(Files.size(there)).isGreaterThan(4);
    }

    /** The file itself, by another name, and where an export keeps what it has begun. */
    @ParameterizedTest
    @CsvSource({
        "sqlite, run.auvsml.gz, run.auvsml.gz",
        "sqlite, link.db, run.auvsml.gz",
        "sqlite, run.db, run.db.part",
        "csv, tables, tables/movements.csv"
    })
    void theRecordingItselfIsNeverWrittenOver(String format, String out, String recording)
            throws IOException {
        Path read = folder.resolve(recording);
        if (!read.equals(file)) {
            Files.createDirectories(read.getParent());
            Files.move(file, read);
        }
        Files.createSymbolicLink(folder.resolve("link.db"), read);
        byte[] before = Files.readAllBytes(read);

        assertThat(
                        auvsim.run(
                                "export",
                                read,
                                "--format",
                                format,
                                "--out",
                                folder.resolve(out),
                                "--force"))
                .isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(read + " is the recording that is read; name another place by --out.\n");
        assertThat(Files.readAllBytes(read)).isEqualTo(before);
    }

    @ParameterizedTest
    @CsvSource({
        "csv, run.db, '--format csv needs a folder, but %s is a file; name another place by"
                + " --out.'",
        "sqlite, f, '--format sqlite needs a file, but %s is a folder; name another place by"
                + " --out.'"
    })
    void whatIsInTheWayIsTold(String format, String name, String sentence) throws IOException {
        Files.createFile(folder.resolve("run.db"));
        Files.createDirectory(folder.resolve("f"));
        Path out = folder.resolve(name);

        assertThat(auvsim.run("export", file, "--format", format, "--out", out, "--force"))
                .isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(sentence.formatted(out) + "\n");
    }

    @Test
    void oneThatWasCutOffIsExportedAsFarAsItGoes() throws IOException {
        byte[] whole = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(whole, whole.length - 5));
        Path out = folder.resolve("tables");

        assertThat(export("csv", out)).isZero();

        assertThat(auvsim.err())
                .startsWith(file + ": notice: it ends at step 1 (0.5 s): ")
                .hasLineCount(1);
        assertThat(Files.readAllLines(out.resolve("movements.csv"))).hasSize(3);
    }

    /** A byte of the second half is another one: nothing of it is exported. */
    @ParameterizedTest
    @CsvSource({"csv, tables", "sqlite, run.db"})
    void oneThatIsDamagedLeavesNoFiles(String format, String name) throws IOException {
        byte[] whole = Files.readAllBytes(file);
        whole[whole.length * 3 / 4] ^= 0x55;
        Files.write(file, whole);

        assertThat(export(format, folder.resolve(name))).isEqualTo(2);

        assertThat(auvsim.err()).contains(file.toString()).hasLineCount(1);
        try (var left = Files.list(folder)) {
            assertThat(left).containsExactly(file);
        }
    }

    @Test
    void whatIsNoRecordingIsExplained() throws IOException {
        Path empty = Files.createFile(folder.resolve("empty.auvsml.gz"));
        assertThat(auvsim.run("export", empty, "--format", "csv", "--out", folder)).isEqualTo(2);
        assertThat(auvsim.err()).contains("a recording begins with <recording>").hasLineCount(1);
    }

    @Test
    void aWrongFormatIsExplained() {
        assertThat(export("xml", folder.resolve("out"))).isEqualTo(2);
        assertThat(auvsim.err().lines())
                .first()
                .isEqualTo("--format: expected csv or sqlite, but found 'xml'.");
    }

    @ParameterizedTest
    @CsvSource({"csv, none/tables", "sqlite, none/run.db"})
    void aFolderThatIsMissingIsExplained(String format, String name) {
        assertThat(export(format, folder.resolve(name))).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        "Cannot write %s: its folder does not exist.\n"
                                .formatted(folder.resolve(name)));
    }

    private int export(String format, Path out) {
        return auvsim.run("export", file, "--format", format, "--out", out);
    }
}
