package org.auvsim.cli.demo;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.message.learning.ModelCorrectionNotification;
import org.auvsim.server.net.TransportException;
import org.auvsim.server.simulator.Simulator;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The demonstration: the same flight three times, without feedback, with direct alteration and with
 * vector adjustment, over real sockets; then the errors side by side, and a picture.
 */
public final class Demonstration {
    /** The vehicle's id in the scenario. */
    static final long ROBOT_ID = 1;

    /** Of the noise of the robot's sensor. */
    static final long SEED = 2012;

    /** So many steps pass between two measurements. */
    static final int FEEDBACK_EVERY = 10;

    private static final String SCENARIO = "demo.xml";

    private final LiveTable table;
    private final PrintWriter out;

    /** A demonstration that shows what happens on {@code out}. */
    public Demonstration(PrintWriter out) {
        this.out = out;
        this.table = new LiveTable(out);
    }

    /**
     * Flies, and writes {@code demo.png} and {@code demo.html} into a folder.
     *
     * @throws TransportException if the server cannot listen
     * @throws IOException if a client loses the server, or the files cannot be written
     */
    public void run(Path folder) throws IOException, TransportException {
        DemoReport.prepare(folder);
        out.printf(
                "A robot flies a square by commands. The real one feels a drag and a current"
                    + " that%nthe scenario lacks; it measures its position with 5 mm of noise (seed"
                    + " %d).%nIn the last act the server finds out what they are.%n",
                SEED);
        List<Track> tracks = new ArrayList<>();
        tracks.add(fly("without feedback", Optional.empty()));
        tracks.add(fly("direct alteration", Optional.of("DirectPositionChangeFeedbackHandler")));
        tracks.add(fly("vector adjustment", Optional.of("VectorAdjustmentFeedbackHandler")));
        Track all = new Track("learning from feedback");
        Optional<ModelCorrectionNotification> learned = learn(all);
        double at = learned.map(ModelCorrectionNotification::timestamp).orElse(Double.MAX_VALUE);
        List<Track> rows = new ArrayList<>(tracks);
        rows.add(all.part("while it learns", 0, at));
        learned.ifPresent(_ -> rows.add(all.part("with what it learned", at, Double.MAX_VALUE)));
        table.summary(rows);
        out.printf("%n%s%n", DemoReport.WHY_ALIKE);
        out.printf("%nWhat the server has learned:%n%s%n", sentence(learned));
        Path report = DemoReport.write(folder, rows, all, sentence(learned));
        out.printf("%nThe picture: %s%n", report.toAbsolutePath());
        out.flush();
    }

    private Optional<ModelCorrectionNotification> learn(Track track)
            throws IOException, TransportException {
        table.beginLong(track);
        return new LearningFlight(scenario(), track, table).fly();
    }

    /** What was learned, for people. */
    private static String sentence(Optional<ModelCorrectionNotification> learned) {
        return learned.map(found -> found.modelCorrection().sentence())
                .orElse("nothing: no cause explains what the robot measured");
    }

    private Track fly(String name, Optional<String> handler)
            throws IOException, TransportException {
        Track track = new Track(name);
        table.begin(track);
        Optional<Sensors> sensors = handler.map(of -> new Sensors(of, FEEDBACK_EVERY, false));
        int refused =
                new Flight(Simulator.of(scenario()), new FlightPlan(), sensors, track, table)
                        .fly(_ -> FlightPlan.DURATION)
                        .refused();
        if (refused > 0) {
            out.printf("  %d corrections came too late for their step and were refused%n", refused);
        }
        return track;
    }

    private static Scenario scenario() {
        try (InputStream in = Demonstration.class.getResourceAsStream(SCENARIO)) {
            if (in == null) {
                throw new IllegalStateException(SCENARIO + " is missing from the program");
            }
            return ScenarioLoader.load(ContextClasses.loader()).parse(in.readAllBytes());
        } catch (AuvsmlException e) {
            throw new IllegalStateException("the shipped " + SCENARIO + " is wrong", e);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
