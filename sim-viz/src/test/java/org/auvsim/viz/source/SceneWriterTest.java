package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.control.SnapshotRestoredNotification;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.auvsml.message.session.LaggingSide;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;
import org.junit.jupiter.api.Test;

class SceneWriterTest {
    private final Scene scene = new Scene(new LiveClock());
    private final SceneWriter writer = new SceneWriter(scene);

    @Test
    void whoIsTooSlowAndWhatThatMeansIsSaid() {
        writer.write(new LaggingNotification(LaggingSide.CLIENT, 7));
        writer.write(new LaggingNotification(LaggingSide.SIMULATOR, 1));
        writer.write(new LaggingNotification(LaggingSide.SIMULATOR, 3));
        assertThat(scene.drainOccurrences())
                .extracting(Occurrence::text)
                .containsExactly(
                        "This viewer is too slow: it was not told of 7 movements, which newer ones"
                                + " replaced; the world is right.",
                        "The simulator is too slow for its rate: the world's time has fallen behind"
                                + " by 1 step more; every step is made.",
                        "The simulator is too slow for its rate: the world's time has fallen behind"
                                + " by 3 steps more; every step is made.");
    }

    @Test
    void fromWhereTimeGoesOnIsSaidInWords() {
        writer.write(new SnapshotRestoredNotification(0, 0, "*BEGINNING*"));
        writer.write(new SnapshotRestoredNotification(0, 0, "*SCENARIO*"));
        writer.write(new SnapshotRestoredNotification(60, 3, "before"));
        assertThat(scene.drainOccurrences())
                .containsExactly(
                        new Occurrence(0, "Time goes on from here: the beginning of the world"),
                        new Occurrence(0, "Time goes on from here: another scenario"),
                        new Occurrence(3, "Time goes on from here: the snapshot 'before'"));
    }
}
