package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.TakeControlCommand;
import org.auvsim.viz.driving.Driving;
import org.auvsim.viz.driving.Gamepad;
import org.auvsim.viz.driving.Orders;
import org.auvsim.viz.driving.Sticks;
import org.auvsim.viz.driving.Wanted;
import org.auvsim.viz.driving.Way;
import org.auvsim.viz.scene.SeenObject;
import org.auvsim.viz.source.LostException;

import java.awt.KeyEventDispatcher;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;

/** Drives the selected object by keys and gamepad while driving is on. */
final class Driver implements KeyEventDispatcher {
    private static final Optional<Orders> NONE = Optional.of(Orders.NONE);

    private final Desk desk;
    private final Gamepad gamepad;
    private final Window window;
    private final HeldKeys keys = new HeldKeys();
    private Optional<Long> driven = Optional.empty();
    private Optional<Driving> driving = Optional.empty();
    private Wanted before = Wanted.NOTHING;
    private boolean wasAstern;
    private Way way = new Way();

    /** What it has been told to do; empty while that is not known, as an order has failed. */
    private Optional<Orders> orders = NONE;

    Driver(Desk desk, Gamepad gamepad, Window window) {
        this.desk = desk;
        this.gamepad = gamepad;
        this.window = window;
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent e) {
        boolean isOurs =
                desk.isDriving()
                        && HeldKeys.drives(e.getKeyCode())
                        && !e.isControlDown()
                        && !e.isAltDown()
                        && window.isFocused()
                        && !Typing.isUnderWay();
        if (e.getID() == KeyEvent.KEY_RELEASED) {
            keys.release(e.getKeyCode());
        } else if (isOurs && e.getID() == KeyEvent.KEY_PRESSED) {
            keys.press(e.getKeyCode());
        }
        return isOurs;
    }

    /** Sends what keys and sticks ask for, ten times a second. */
    void turn() {
        keys.settle();
        if (!window.isFocused()) {
            keys.letGo();
        }
        // Who comes back to a simulator has let go of everything there, and asks for it again.
        Optional<SeenObject> object =
                desk.isDriving() && !desk.isLost() ? desk.selected() : Optional.empty();
        if (!object.map(SeenObject::id).equals(driven)) {
            boolean isGone = driven.isPresent() && object.isEmpty() && !desk.isLost();
            stop();
            if (isGone) {
                desk.drive(false);
            }
            object.ifPresent(this::begin);
        }
        if (driving.isEmpty() || driven.isEmpty()) {
            return;
        }
        Wanted wanted =
                keys.wanted().plus(gamepad.poll().map(Sticks::wanted).orElse(Wanted.NOTHING));
        look(driven.get());
        boolean turnsRound = way.isAstern() != wasAstern && !wanted.equals(Wanted.NOTHING);
        if (!wanted.equals(before) || turnsRound || orders.isEmpty()) {
            before = wanted;
            wasAstern = way.isAstern();
            give(driving.get().orders(wanted, wasAstern));
        }
    }

    private void look(long id) {
        desk.scene()
                .motion(id)
                .ifPresent(m -> way.see(m, desk.scene().water().velocity(m.position(), m.time())));
    }

    private void begin(SeenObject object) {
        driven = Optional.of(object.id());
        way = new Way();
        wasAstern = false;
        driving = object.definition().map(Driving::new).filter(Driving::isPossible);
        if (!desk.may(Role.CONTROLLER) || driving.isEmpty()) {
            desk.say(
                    desk.hindrance(Role.CONTROLLER)
                            .orElse(object.name() + " cannot be driven: nothing moves it."));
            giveUp();
        } else {
            ask(new TakeControlCommand(object.id()), () -> {});
        }
    }

    /** Lets go of what was driven. */
    private void stop() {
        if (!before.equals(Wanted.NOTHING) && !desk.isLost()) {
            driving.ifPresent(d -> give(d.orders(Wanted.NOTHING, wasAstern)));
        }
        forget();
    }

    private void forget() {
        driving = Optional.empty();
        driven = Optional.empty();
        before = Wanted.NOTHING;
        orders = NONE;
    }

    /** Drives no more; what was not refused is not to push for ever. */
    private void giveUp() {
        if (!orders.equals(NONE)) {
            Orders nothing = driving.orElseThrow().orders(Wanted.NOTHING, wasAstern);
            nothing.all(driven.orElseThrow()).forEach(desk::askQuietly);
        }
        forget();
        desk.drive(false);
    }

    /** Asks for something; where that is refused, as somebody else has control, nobody drives. */
    private void ask(Message message, Runnable failed) {
        Optional<Long> asked = driven;
        desk.ask(
                message,
                answer -> {},
                failure -> {
                    if (asked.equals(driven)) {
                        failed.run();
                        if (!(failure instanceof LostException)) {
                            giveUp();
                        }
                    }
                });
    }

    private void give(Orders others) {
        long id = driven.orElseThrow();
        List<Message> messages =
                orders.map(known -> others.since(known, id)).orElseGet(() -> others.all(id));
        orders = Optional.of(others);
        messages.forEach(message -> ask(message, () -> orders = Optional.empty()));
    }
}
