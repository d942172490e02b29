package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

import java.util.concurrent.atomic.AtomicBoolean;

import javax.swing.JLabel;
import javax.swing.JPanel;

/** Somebody looks at the plots below the picture; needs a display. */
@Tag("display")
class PlotsPanelTest {
    @RegisterExtension private final OpenedWindow window = new OpenedWindow();

    @Test
    void plotsShowTheLastMinuteOfWhatIsSelectedOrSayWhyThereIsNone() throws Exception {
        Scene scene = Scenes.withBuoy();
        scene.add(SeenObject.of(10, Scenes.rock()));
        window.open(new FakeSimulator(scene));
        Clicks.inSwing(
                () -> {
                    JLabel hint = window.find("plots-hint", JLabel.class);
                    assertThat(hint.isShowing()).isTrue();
                    assertThat(hint.getText()).startsWith("Select an object");
                    window.select(10);
                    assertThat(hint.getText()).isEqualTo("Rock is fixed: it does not move");
                    window.select(9);
                    assertThat(hint.getText()).isEqualTo("Buoy: no data yet");
                    scene.move(9, atRest(1));
                    scene.move(9, atRest(2));
                    scene.stepDone(2, 0);
                    scene.look(Long.MAX_VALUE / 2, look -> {});
                    window.select(10);
                    window.select(9);
                    assertThat(window.find("plots", JPanel.class).isShowing()).isTrue();
                    assertThat(hint.isShowing()).isFalse();
                });
    }

    private static Movement atRest(double time) {
        return new Movement(time, Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
    }

    @Test
    void aSmallWindowHasFewerPlots() throws Exception {
        window.open(new FakeSimulator(Scenes.withBuoy()));
        JPanel plots = window.find("plots", JPanel.class);
        Clicks.inSwing(() -> assertThat(plots.getComponentCount()).isEqualTo(4));
        Clicks.inSwing(() -> window.frame().setSize(window.frame().getMinimumSize()));
        AtomicBoolean isSmall = new AtomicBoolean();
        while (!isSmall.get()) {
            Clicks.inSwing(() -> isSmall.set(plots.getComponentCount() < 4));
        }
    }
}
