package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;

import java.util.Optional;
import java.util.OptionalLong;

class ChoiceTest {
    private final Scene scene = Scenes.withBuoy();
    private final ViewOptions options = new ViewOptions();
    private final Choice choice = new Choice(scene, options::selected, options::select);

    ChoiceTest() {
        options.select(OptionalLong.of(9));
        choice.refresh();
    }

    @Test
    void whatIsThereStaysChosen() {
        choice.refresh();
        assertThat(options.selected()).hasValue(9);
    }

    @Test
    void whatHasLeftTheWorldIsLetGo() {
        scene.remove(9);
        choice.refresh();
        choice.refresh();
        assertThat(options.selected()).isEmpty();
    }

    @Test
    void whatComesBackAfterABrokenConnectionIsTakenAgain() {
        scene.clear();
        choice.refresh();
        scene.add(SeenObject.of(9, Scenes.buoy()));
        choice.refresh();
        assertThat(options.selected()).hasValue(9);
    }

    @Test
    void anotherObjectOfTheSameIdIsNotTaken() {
        scene.clear();
        scene.add(new SeenObject(9, "Whale", Optional.empty()));
        choice.refresh();
        assertThat(options.selected()).isEmpty();
        choice.refresh();
        assertThat(options.selected()).isEmpty();
    }

    @Test
    void anotherObjectOfTheSameIdCanBeChosen() {
        scene.remove(9);
        choice.refresh();
        scene.clear();
        scene.add(new SeenObject(9, "Whale", Optional.empty()));
        choice.refresh();
        options.select(OptionalLong.of(9));
        choice.refresh();
        choice.refresh();
        assertThat(options.selected()).hasValue(9);
    }

    @Test
    void whatSomebodyHasLetGoOfStaysSo() {
        options.select(OptionalLong.empty());
        choice.refresh();
        choice.refresh();
        assertThat(options.selected()).isEmpty();
    }

    @Test
    void whatWasChosenMeanwhileStaysChosen() {
        scene.add(new SeenObject(10, "Whale", Optional.empty()));
        scene.remove(9);
        choice.refresh();
        options.select(OptionalLong.of(10));
        choice.refresh();
        scene.add(SeenObject.of(9, Scenes.buoy()));
        choice.refresh();
        assertThat(options.selected()).hasValue(10);
    }
}
