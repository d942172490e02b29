package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.auvsml.message.control.TakeControlCommand;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.driving.Sticks;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JTextField;

/** Somebody drives by keys and sticks; needs a display for the focus. */
@Tag("display")
@Timeout(60)
class DriverTest {
    private static final Message TAKE = new TakeControlCommand(9);
    private static final Message AHEAD =
            new ApplyDirectForceCommand(9, "Viewer", Frame.BODY, new Vec3(20, 0, 0));
    private static final Message STOP = new RemoveForceCommand(9, "Viewer");

    private final ViewOptions options = new ViewOptions();
    private final JFrame frame = new JFrame();
    private Optional<Sticks> sticks = Optional.empty();

    private Optional<Desk> desk = Optional.empty();

    private Driver driver(FakeSimulator simulator, long id) {
        Desk shared = new Desk(simulator, new OrbitCamera(), new FakeScreen(), options);
        shared.select(OptionalLong.of(id));
        shared.drive(true);
        desk = Optional.of(shared);
        return new Driver(shared, () -> sticks, frame);
    }

    /** One that a stick pushes the buoy ahead by. */
    private Driver pushing(FakeSimulator simulator) {
        sticks = Optional.of(new Sticks(0, -1, 0, 0, 0, 0));
        return driver(simulator, 9);
    }

    @AfterEach
    void close() throws Exception {
        Clicks.inSwing(frame::dispose);
    }

    /** Shows the frame with a part that has the focus. */
    private void show(JComponent part) throws Exception {
        Clicks.inSwing(
                () -> {
                    frame.add(part);
                    frame.setSize(200, 100);
                    frame.setVisible(true);
                });
        while (!part.isFocusOwner()) {
            Clicks.inSwing(part::requestFocus); // of another window's, if one still has it
        }
    }

    private boolean key(Driver driver, int what, int modifiers, int key) {
        return driver.dispatchKeyEvent(
                new KeyEvent(frame, what, 0, modifiers, key, KeyEvent.CHAR_UNDEFINED));
    }

    @Test
    void aHeldKeyPushesUntilItIsLetGo() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        Driver driver = driver(simulator, 9);
        show(new JButton());
        Clicks.inSwing(
                () -> {
                    assertThat(key(driver, KeyEvent.KEY_PRESSED, 0, KeyEvent.VK_W)).isTrue();
                    driver.turn();
                    driver.turn();
                    key(driver, KeyEvent.KEY_RELEASED, 0, KeyEvent.VK_W);
                    driver.turn();
                });
        assertThat(simulator.asked).containsExactly(TAKE, AHEAD, STOP);
    }

    @Test
    void otherKeysAndThoseOfMenusAreNotTaken() throws Exception {
        Driver driver = driver(new FakeSimulator(Scenes.withBuoy()), 9);
        show(new JButton());
        Clicks.inSwing(
                () -> {
                    assertThat(key(driver, KeyEvent.KEY_PRESSED, 0, KeyEvent.VK_Y)).isFalse();
                    int control = InputEvent.CTRL_DOWN_MASK;
                    assertThat(key(driver, KeyEvent.KEY_PRESSED, control, KeyEvent.VK_S)).isFalse();
                });
    }

    @Test
    void whatIsTypedIntoATextDrivesNothing() throws Exception {
        Driver driver = driver(new FakeSimulator(Scenes.withBuoy()), 9);
        show(new JTextField());
        Clicks.inSwing(
                () -> assertThat(key(driver, KeyEvent.KEY_PRESSED, 0, KeyEvent.VK_W)).isFalse());
    }

    @Test
    void afterAReconnectionWhatIsHeldIsAskedForAgain() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        Driver driver = pushing(simulator);
        Clicks.inSwing(
                () -> {
                    driver.turn();
                    simulator.isConnected = false;
                    driver.turn();
                    simulator.isConnected = true;
                    driver.turn();
                });
        assertThat(simulator.asked).containsExactly(TAKE, AHEAD, TAKE, AHEAD);
    }

    @Test
    void anOrderThatIsOpenWhenTheConnectionBreaksDoesNotEndDriving() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        Driver driver = pushing(simulator);
        simulator.loses = AHEAD::equals;
        Clicks.inSwing(driver::turn);
        Clicks.inSwing(() -> simulator.isConnected = false); // after the answers
        Clicks.inSwing(driver::turn);
        simulator.loses = _ -> false;
        simulator.isConnected = true;
        Clicks.inSwing(driver::turn);
        assertThat(desk.orElseThrow().isDriving()).isTrue();
        assertThat(simulator.asked).containsExactly(TAKE, AHEAD, TAKE, AHEAD);
    }

    @Test
    void whatIsRefusedIsDrivenNoMore() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        simulator.refusal = Optional.of("REMUS controls it.");
        Driver driver = pushing(simulator);
        Clicks.inSwing(driver::turn);
        Clicks.inSwing(driver::turn); // after the answers
        assertThat(desk.orElseThrow().isDriving()).isFalse();
        assertThat(simulator.asked).containsExactly(TAKE, AHEAD, STOP);
        assertThat(desk.orElseThrow().refusal()).contains("REMUS controls it.");
    }

    @Test
    void anOrderThatIsLostIsGivenAgain() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        Driver driver = pushing(simulator);
        simulator.loses = STOP::equals;
        letGo(driver);
        Clicks.inSwing(() -> simulator.loses = _ -> false); // after the answers
        Clicks.inSwing(driver::turn);
        Clicks.inSwing(driver::turn);
        assertThat(simulator.asked).containsExactly(TAKE, AHEAD, STOP, STOP);
    }

    @Test
    void whatCannotBeStoppedIsToldSoOnceMore() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        Driver driver = pushing(simulator);
        simulator.refuses = STOP::equals;
        letGo(driver);
        Clicks.inSwing(driver::turn); // after the answers
        assertThat(desk.orElseThrow().isDriving()).isFalse();
        assertThat(simulator.asked).containsExactly(TAKE, AHEAD, STOP, STOP);
    }

    /** The stick is in its middle again after a turn. */
    private void letGo(Driver driver) throws Exception {
        Clicks.inSwing(driver::turn);
        sticks = Optional.empty();
        Clicks.inSwing(driver::turn);
    }

    @Test
    void whereAnOrderIsRefusedWhatElsePushesIsStopped() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.of("remus-turn.xml"));
        Driver driver = driver(simulator, 1);
        sticks = Optional.of(new Sticks(0, -1, 0, 0, 0, 0));
        simulator.refuses = SetControlSurfaceCommand.class::isInstance;
        Clicks.inSwing(driver::turn);
        Clicks.inSwing(driver::turn); // after the answers
        assertThat(desk.orElseThrow().isDriving()).isFalse();
        assertThat(simulator.asked)
                .filteredOn(SetPropulsorCommand.class::isInstance)
                .hasSize(2)
                .last()
                .isEqualTo(new SetPropulsorCommand(1, "Propeller", 0));
        assertThat(desk.orElseThrow().refusal()).contains("Not this.");
    }

    @Test
    void whatNothingMovesIsNotDriven() throws Exception {
        Scene scene = Scenes.withBuoy();
        scene.add(new SeenObject(10, "Thing", Optional.empty()));
        FakeSimulator simulator = new FakeSimulator(scene);
        Driver driver = driver(simulator, 10);
        Clicks.inSwing(driver::turn);
        assertThat(desk.orElseThrow().isDriving()).isFalse();
        assertThat(simulator.asked).isEmpty();
    }

    @Test
    void whatHasLeftTheWorldIsDrivenNoMore() throws Exception {
        FakeSimulator simulator = new FakeSimulator(Scenes.withBuoy());
        Driver driver = driver(simulator, 9);
        Clicks.inSwing(driver::turn);
        assertThat(desk.orElseThrow().isDriving()).isTrue();
        simulator.scene().remove(9);
        Clicks.inSwing(driver::turn);
        assertThat(desk.orElseThrow().isDriving()).isFalse();
    }

    @Test
    void finsTurnRoundWhenTheObjectGoesAstern() throws Exception {
        Scene scene = Scenes.of("remus-turn.xml");
        FakeSimulator simulator = new FakeSimulator(scene);
        Driver driver = driver(simulator, 1);
        sticks = Optional.of(new Sticks(-1, 0, 0, 0, 0, 0));
        move(scene, 0.5);
        Clicks.inSwing(driver::turn);
        double ahead = rudder(simulator.asked);
        simulator.asked.clear();
        move(scene, -0.5);
        Clicks.inSwing(driver::turn);
        assertThat(rudder(simulator.asked)).isEqualTo(-ahead).isNotZero();
    }

    private static void move(Scene scene, double surge) {
        Vec3 velocity = new Vec3(surge, 0, 0);
        scene.jump(1, new Movement(1, Vec3.ZERO, Quat.IDENTITY, velocity, Vec3.ZERO));
        scene.look(0, look -> {});
    }

    private static double rudder(List<Message> asked) {
        return asked.stream()
                .filter(SetControlSurfaceCommand.class::isInstance)
                .map(SetControlSurfaceCommand.class::cast)
                .filter(command -> command.name().equals("Upper Rudder"))
                .findFirst()
                .orElseThrow()
                .angle();
    }
}
