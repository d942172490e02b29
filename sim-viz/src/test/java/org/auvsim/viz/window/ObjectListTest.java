package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

import java.awt.Component;
import java.awt.Rectangle;
import java.util.Optional;
import java.util.OptionalLong;

import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JTextField;

/** Somebody finds objects in the tree; needs a display. */
@Tag("display")
class ObjectListTest {
    @RegisterExtension private final OpenedWindow window = new OpenedWindow();

    private JTable objects() {
        return window.find("objects", JTable.class);
    }

    private static Object selectedIn(JTable objects) {
        return objects.getValueAt(objects.getSelectedRow(), 0);
    }

    @Test
    void selectsInTheListAndInThePicture() throws Exception {
        window.open(new FakeSimulator(Scenes.of("bluerov2-dive.xml")));
        Clicks.inSwing(
                () -> {
                    JTextField filter = window.find("filter", JTextField.class);
                    filter.setText("rov");
                    assertThat(objects().getRowCount()).isEqualTo(2);
                    objects().setRowSelectionInterval(1, 1);
                    assertThat(window.view().selected()).isEqualTo(OptionalLong.of(1));
                    JLabel nothing = window.find("nothing", JLabel.class);
                    assertThat(nothing.isVisible()).isFalse();
                    filter.setText("Nemo");
                    assertThat(nothing.isVisible()).isTrue();
                    filter.setText("");
                    assertThat(nothing.isVisible()).isFalse();
                    window.camera().aim(5, 0, 0, 20);
                    Component screen = window.find("screen", Component.class);
                    Clicks.click(screen, screen.getWidth() / 2, screen.getHeight() / 2);
                });
        assertThat(window.view().selected()).isEqualTo(OptionalLong.of(9));
        Clicks.inSwing(() -> assertThat(selectedIn(objects())).isEqualTo("Buoy"));
    }

    @Test
    void whatIsSelectedInThePictureIsUnfoldedInTheTree() throws Exception {
        window.open(new FakeSimulator(Scenes.withBuoy()));
        Clicks.inSwing(
                () -> {
                    JTable objects = objects();
                    Clicks.click(objects, 4, objects.getRowHeight() / 2);
                    assertThat(objects.getRowCount()).isEqualTo(1);
                    window.select(9);
                    assertThat(objects.getRowCount()).isEqualTo(2);
                    assertThat(objects.getSelectedRow()).isEqualTo(1);
                });
    }

    @Test
    void aListInOrderOfDistanceStaysWhereItIsScrolledAndKeepsItsRow() throws Exception {
        Scene scene = Scenes.withBuoy();
        for (long id = 10; id < 200; id++) {
            scene.add(SeenObject.of(id, Scenes.rock()));
        }
        window.open(new FakeSimulator(scene));
        Clicks.inSwing(
                () -> {
                    JTable objects = objects();
                    window.select(9);
                    objects.getRowSorter().toggleSortOrder(ObjectRows.DISTANCE);
                    assertThat(selectedIn(objects)).isEqualTo("Buoy");
                    int last = objects.getRowCount() - 1;
                    objects.scrollRectToVisible(objects.getCellRect(last, 0, true));
                    Rectangle seen = objects.getVisibleRect();
                    assertThat(seen.y).isPositive();
                    turnOften();
                    assertThat(objects.getVisibleRect()).isEqualTo(seen);
                    assertThat(selectedIn(objects)).isEqualTo("Buoy");
                });
    }

    @Test
    void aListInOrderKeepsTheRowTheKeyboardIsOnThoughNothingIsSelected() throws Exception {
        window.open(new FakeSimulator(Scenes.withBuoy()));
        Clicks.inSwing(
                () -> {
                    JTable objects = objects();
                    objects.getRowSorter().toggleSortOrder(ObjectRows.SPEED);
                    objects.setRowSelectionInterval(0, 0);
                    turnOften();
                    assertThat(window.view().selected()).isEmpty();
                    assertThat(objects.getSelectedRow()).isZero();
                });
    }

    @Test
    void inAnotherWorldAnObjectWithTheIdOfOneThatHasGoneCanBeSelected() throws Exception {
        Scene scene = Scenes.withBuoy();
        window.open(new FakeSimulator(scene));
        Clicks.inSwing(
                () -> {
                    objects().setRowSelectionInterval(1, 1);
                    scene.remove(9);
                    window.turn();
                    assertThat(window.view().selected()).isEmpty();
                    scene.clear();
                    scene.add(new SeenObject(9, "Whale", Optional.empty()));
                    window.turn();
                    objects().setRowSelectionInterval(1, 1);
                    window.turn();
                    assertThat(window.view().selected()).hasValue(9);
                    assertThat(selectedIn(objects())).isEqualTo("Whale");
                });
    }

    /** So often that what moves is put in order again. */
    private void turnOften() {
        for (int turn = 0; turn < 20; turn++) {
            window.turn();
        }
    }
}
