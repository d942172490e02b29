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
    void oneThatIsLeftOutIsToldOfAsOne() {
        writer.write(new LaggingNotification(LaggingSide.CLIENT, 1));
        assertThat(scene.drainOccurrences())
                .containsExactly(new Occurrence(0, "Too slow; movements or steps left out: 1"));
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
