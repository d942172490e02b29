package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.control.ReleaseControlCommand;
import org.auvsim.auvsml.message.control.TakeControlCommand;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.viz.scene.SeenObject;

import java.awt.Window;
import java.util.Optional;
import java.util.function.LongConsumer;
import java.util.function.Supplier;

import javax.swing.Action;
import javax.swing.JMenu;

/** What can be done with the selected object. */
final class ObjectMenu {
    private final Desk desk;
    private final Window window;
    private final EffectDialog effects;
    private final Action drive;

    ObjectMenu(Desk desk, Window window) {
        this.desk = desk;
        this.window = window;
        effects = new EffectDialog(desk, window);
        drive =
                new Act("Drive by keys and gamepad", () -> desk.drive(!desk.isDriving()))
                        .key("ctrl D")
                        .tip("W S A D Q E R F and the arrows drive the selected object")
                        .unless(desk, () -> desk.hindranceAtControlled(Role.CONTROLLER));
    }

    Action drive() {
        return drive;
    }

    JMenu menu() {
        JMenu menu = new JMenu("Object");
        menu.setName("menu-object");
        menu.setMnemonic('O');
        menu.add(drive).setName("drive");
        menu.add(act("Take control", this::take, desk::hindranceAtTaking))
                .setName("take-control-item");
        menu.add(act("Release", this::release, desk::hindranceAtRelease))
                .setName("release-control-item");
        menu.addSeparator();
        menu.add(act("Add an effect...", effects::open, this::hindrance)).setName("add-effect");
        menu.add(act("Remove from the world...", this::remove, this::hindrance))
                .setName("remove-entity");
        return menu;
    }

    private Optional<String> hindrance() {
        return desk.hindranceAtSelected(Role.ADMIN);
    }

    private void take(long id) {
        desk.ask(new TakeControlCommand(id));
    }

    private void release(long id) {
        desk.ask(new ReleaseControlCommand(id));
    }

    private void remove(long id) {
        String name = desk.scene().object(id).map(SeenObject::name).orElse("#" + id);
        String question =
                "Remove %s from the world for all clients, and lose it as it is now?"
                        .formatted(name);
        if (Question.confirms(window, question, "Remove")) {
            desk.ask(new RemoveEntityCommand(id));
        }
    }

    private Act act(String words, LongConsumer deed, Supplier<Optional<String>> hindrance) {
        return new Act(words, () -> desk.options().selected().ifPresent(deed))
                .unless(desk, hindrance);
    }
}
