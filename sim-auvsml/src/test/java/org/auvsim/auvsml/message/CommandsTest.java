package org.auvsim.auvsml.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.message.command.Command;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.Listener;
import org.auvsim.auvsml.message.command.SessionControl;
import org.auvsim.auvsml.message.command.SimulatorControl;
import org.auvsim.auvsml.message.command.SimulatorState;
import org.auvsim.auvsml.message.command.SimulatorView;
import org.auvsim.auvsml.message.command.WorldControl;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.auvsml.message.command.WorldView;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.ApplyForceCommand;
import org.auvsim.auvsml.message.control.GetSimulatorStateRequest;
import org.auvsim.auvsml.message.control.PauseSimulatorCommand;
import org.auvsim.auvsml.message.control.ReleaseControlCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.RestoreSnapshotCommand;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.control.SetFeedbackProcessorCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.auvsml.message.control.SetRateCommand;
import org.auvsim.auvsml.message.control.SetTimestepperCommand;
import org.auvsim.auvsml.message.control.ShutdownSimulatorCommand;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.control.StepCommand;
import org.auvsim.auvsml.message.control.TakeControlCommand;
import org.auvsim.auvsml.message.control.TakeSnapshotCommand;
import org.auvsim.auvsml.message.entity.AddEffectCommand;
import org.auvsim.auvsml.message.entity.AddFieldCommand;
import org.auvsim.auvsml.message.entity.AddWorldObjectCommand;
import org.auvsim.auvsml.message.entity.AddWorldObjectResponse;
import org.auvsim.auvsml.message.entity.ControlSurfaceListResponse;
import org.auvsim.auvsml.message.entity.DescribeWorldObjectRequest;
import org.auvsim.auvsml.message.entity.EffectListResponse;
import org.auvsim.auvsml.message.entity.FieldListResponse;
import org.auvsim.auvsml.message.entity.GetControlSurfaceListRequest;
import org.auvsim.auvsml.message.entity.GetEffectListRequest;
import org.auvsim.auvsml.message.entity.GetFieldListRequest;
import org.auvsim.auvsml.message.entity.GetPropulsorListRequest;
import org.auvsim.auvsml.message.entity.GetWorldObjectListCommand;
import org.auvsim.auvsml.message.entity.ListedControlSurface;
import org.auvsim.auvsml.message.entity.ListedPropulsor;
import org.auvsim.auvsml.message.entity.PropulsorListResponse;
import org.auvsim.auvsml.message.entity.RemoveEffectCommand;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.auvsml.message.entity.WorldObjectDescriptionResponse;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.radio.SendAcousticMessageCommand;
import org.auvsim.auvsml.message.radio.SendRadioMessageCommand;
import org.auvsim.auvsml.message.sensing.GetSensorListRequest;
import org.auvsim.auvsml.message.sensing.ListedSensor;
import org.auvsim.auvsml.message.sensing.SensorListResponse;
import org.auvsim.auvsml.message.session.DisconnectClientCommand;
import org.auvsim.auvsml.message.session.DisconnectCommand;
import org.auvsim.core.communication.AcousticModem;
import org.auvsim.core.communication.Radio;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.DepthSensor;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.sensor.Sensor;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** What each command asks of its port, and what it answers. */
class CommandsTest {
    private static final Vec3 UP = new Vec3(0, 0, 1);

    private static final Gravity WEIGHT = new Gravity(9.8);
    private static final UniformCurrent TIDE = new UniformCurrent(5, "Tide", UP);

    private static final FeedbackTimestepping NEVER =
            new FeedbackTimestepping.NoFeedbackTimestepper();

    private final List<String> calls = new ArrayList<>();

    @Test
    void sessionCommands() {
        List<ListenedObject> objects =
                List.of(new ListenedObject("47", List.of(Listener.to(Listener.ALL))));
        silent(SessionControl.class, ListenerRegistrationRequestCommand.ofAll("47"));
        silent(SessionControl.class, new ListenerRegistrationRequestCommand(false, objects));
        silent(SessionControl.class, new TakeControlCommand(47));
        silent(SessionControl.class, new ReleaseControlCommand(47));
        silent(SessionControl.class, new DisconnectCommand());

        assertThat(calls)
                .containsExactly(
                        "register" + List.of(objects),
                        "unregister" + List.of(objects),
                        "takeControl[47]",
                        "releaseControl[47]",
                        "disconnect[]");
    }

    @Test
    void aRegistrationHasItsEventsByName() {
        List<EventType> events = List.of(EventType.COLLISION, EventType.RADIO);
        assertThat(ListenerRegistrationRequestCommand.of(ListenedObject.EVERY, events))
                .isEqualTo(
                        new ListenerRegistrationRequestCommand(
                                true,
                                List.of(
                                        new ListenedObject(
                                                "*",
                                                List.of(
                                                        Listener.to("Collision"),
                                                        Listener.to("Radio"))))));
    }

    @Test
    void simulatorCommands() {
        silent(SimulatorControl.class, new PauseSimulatorCommand());
        silent(SimulatorControl.class, new ResumeSimulatorCommand());
        silent(SimulatorControl.class, new ShutdownSimulatorCommand());
        silent(SimulatorControl.class, new SetRateCommand("2.5"));
        silent(SimulatorControl.class, new SetRateCommand("max"));
        silent(SimulatorControl.class, new StepCommand(3));
        silent(SimulatorControl.class, new TakeSnapshotCommand("a"));
        silent(SimulatorControl.class, new RestoreSnapshotCommand("a"));
        silent(SimulatorControl.class, new ResetCommand());
        silent(SimulatorControl.class, new SetFeedbackProcessorCommand(Optional.of("b")));
        silent(SimulatorControl.class, new SetTimestepperCommand(NEVER));
        silent(SimulatorControl.class, new DisconnectClientCommand("c", "out"));

        assertThat(calls)
                .containsExactly(
                        "pause[]",
                        "resume[]",
                        "shutdown[]",
                        "setRate[OptionalDouble[2.5]]",
                        "setRate[OptionalDouble.empty]",
                        "step[3]",
                        "takeSnapshot[a]",
                        "restoreSnapshot[a]",
                        "reset[]",
                        "setFeedbackProcessor[Optional[b]]",
                        "setTimestepper[" + NEVER + "]",
                        "disconnect[c, out]");
    }

    @Test
    void theStateIsAnswered() {
        SimulatorState state = new SimulatorState(1.5, true, OptionalDouble.empty(), 30, 2);

        assertThat(new GetSimulatorStateRequest().execute(port(SimulatorView.class, state)))
                .contains(new SimulatorStateResponse(1.5, true, "max", 30, 2));
    }

    @Test
    void worldCommands() {
        List<ListedWorldObject> objects =
                List.of(new ListedWorldObject(47, ListedWorldObject.WORLD_OBJECT, "Juggernaut"));
        WorldObjectDefinition rock =
                WorldObjectDefinition.named("Rock").fixed().volume(new Sphere(1)).build();

        assertThat(new GetWorldObjectListCommand().execute(port(WorldView.class, objects)))
                .contains(new WorldObjectListResponse(objects));
        assertThat(
                        new GetPropulsorListRequest(47)
                                .execute(port(WorldView.class, List.of("Rudder"))))
                .contains(new PropulsorListResponse(47, List.of(new ListedPropulsor("Rudder"))));
        assertThat(
                        new GetControlSurfaceListRequest(47)
                                .execute(port(WorldView.class, List.of("Top Fin"))))
                .contains(
                        new ControlSurfaceListResponse(
                                47, List.of(new ListedControlSurface("Top Fin"))));
        assertThat(new AddWorldObjectCommand(rock).execute(port(WorldControl.class, 48L)))
                .contains(new AddWorldObjectResponse(48));
        silent(WorldControl.class, new RemoveEntityCommand(48));
        assertThat(new GetEffectListRequest(47).execute(port(WorldView.class, List.of(WEIGHT))))
                .contains(new EffectListResponse(47, List.of(WEIGHT)));
        assertThat(new DescribeWorldObjectRequest(47).execute(port(WorldView.class, rock)))
                .contains(new WorldObjectDescriptionResponse(rock));
        assertThat(new GetFieldListRequest().execute(port(WorldView.class, List.of(TIDE))))
                .contains(new FieldListResponse(List.of(TIDE)));
        silent(WorldControl.class, new AddFieldCommand(TIDE));
        silent(WorldControl.class, new AddEffectCommand(47, WEIGHT));
        silent(WorldControl.class, new RemoveEffectCommand(47, WEIGHT));
        Sensor sensor =
                new DepthSensor("Keller", UP, 0, 1025, 1025, ScalarErrors.NONE, Sampling.at(10));
        assertThat(new GetSensorListRequest(47).execute(port(WorldView.class, List.of(sensor))))
                .contains(
                        new SensorListResponse(
                                47, List.of(new ListedSensor("Keller", "DepthSensor", 10))));

        assertThat(calls)
                .containsExactly(
                        "worldObjects[]",
                        "propulsorNames[47]",
                        "controlSurfaceNames[47]",
                        "add" + List.of(rock),
                        "remove[48]",
                        "effects[47]",
                        "description[47]",
                        "fields[]",
                        "add" + List.of(TIDE),
                        "addEffect" + List.of(47L, WEIGHT),
                        "removeEffect" + List.of(47L, WEIGHT),
                        "sensors[47]");
    }

    @Test
    void worldObjectCommands() {
        silent(WorldObjectControl.class, new ApplyDirectForceCommand(1, "a", Frame.BODY, UP));
        silent(
                WorldObjectControl.class,
                new ApplyForceCommand(1, "b", Frame.WORLD, UP, new Vec3(1, 0, 0)));
        silent(WorldObjectControl.class, new RemoveForceCommand(1, "a"));
        silent(WorldObjectControl.class, new SetPropulsorCommand(1, "Rudder", -1));
        silent(WorldObjectControl.class, new SendAcousticMessageCommand(1, "Modem", "hello"));
        silent(WorldObjectControl.class, new SendRadioMessageCommand(1, "VHF", "ahoy"));
        silent(WorldObjectControl.class, new SetControlSurfaceCommand(1, "Top Fin", 0.1));

        assertThat(calls)
                .containsExactly(
                        "apply" + List.of(NamedForce.direct("a", Frame.BODY, UP)),
                        "apply" + List.of(new NamedForce("b", Frame.WORLD, UP, new Vec3(1, 0, 0))),
                        "removeForce[a]",
                        "setPropulsorLevel[Rudder, -1.0]",
                        "transmit[" + AcousticModem.class + ", Modem, hello]",
                        "transmit[" + Radio.class + ", VHF, ahoy]",
                        "setControlSurface[Top Fin, 0.1]");
    }

    @Test
    void theKindDecidesWhoMaySendIt() {
        assertThat(new GetWorldObjectListCommand().role()).isEqualTo(Role.VIEWER);
        assertThat(new GetSimulatorStateRequest().role()).isEqualTo(Role.VIEWER);
        assertThat(new DisconnectCommand().role()).isEqualTo(Role.VIEWER);
        assertThat(new TakeControlCommand(47).role()).isEqualTo(Role.CONTROLLER);
        assertThat(new ReleaseControlCommand(47).role()).isEqualTo(Role.CONTROLLER);
        assertThat(new RemoveForceCommand(47, "a").role()).isEqualTo(Role.CONTROLLER);
        assertThat(new AddEffectCommand(47, WEIGHT).role()).isEqualTo(Role.ADMIN);
        assertThat(new PauseSimulatorCommand().role()).isEqualTo(Role.ADMIN);
    }

    @Test
    void whatMakesNoSenseCannotBeMade() {
        assertThatThrownBy(() -> new SetPropulsorCommand(1, "Rudder", 1.5))
                .hasMessage("level must be -1 to 1, but is 1.5");
        assertThatThrownBy(() -> new StepCommand(0))
                .hasMessage("count must be 1 or more, but is 0");
        for (String rate : List.of("0", "-1", "fast", "1e3", "")) {
            assertThatThrownBy(() -> new SetRateCommand(rate))
                    .hasMessage("rate must be a number above 0, or 'max', but is '" + rate + "'");
        }
        for (String id : List.of("0", "-1", "**", "", "99999999999999999999")) {
            assertThatThrownBy(() -> new ListenedObject(id, List.of()))
                    .hasMessageEndingWith("but found '" + id + "'");
        }
    }

    private <P> void silent(Class<P> type, Command<P> command) {
        assertThat(command.execute(port(type, Void.TYPE))).isEmpty();
    }

    /** A port that notes what it is asked, and answers {@code result} where an answer is due. */
    private <P> P port(Class<P> type, Object result) {
        return type.cast(
                Proxy.newProxyInstance(
                        type.getClassLoader(),
                        new Class<?>[] {type},
                        (_, method, arguments) -> {
                            calls.add(
                                    method.getName()
                                            + (arguments == null
                                                    ? "[]"
                                                    : Arrays.toString(arguments)));
                            return method.getReturnType() == void.class ? null : result;
                        }));
    }
}
