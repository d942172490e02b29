package org.auvsim.core.entity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import org.auvsim.core.actuator.Battery;
import org.auvsim.core.actuator.Condition;
import org.auvsim.core.actuator.Failure;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.PolynomialThrust;
import org.auvsim.core.actuator.PowerDraw;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.actuator.Reached;
import org.auvsim.core.actuator.Rotor;
import org.auvsim.core.actuator.Sag;
import org.auvsim.core.actuator.ThrustTable;
import org.auvsim.core.actuator.ThrustTable.ThrustPoint;
import org.auvsim.core.communication.AcousticModem;
import org.auvsim.core.communication.Radio;
import org.auvsim.core.effect.AnisotropicDrag;
import org.auvsim.core.effect.Brake;
import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.effect.CoulombFriction;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.DampingTerm;
import org.auvsim.core.effect.Derivative;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.effect.Kick;
import org.auvsim.core.effect.MagneticAttraction;
import org.auvsim.core.effect.MagneticDipole;
import org.auvsim.core.effect.MagnusForce;
import org.auvsim.core.effect.Mooring;
import org.auvsim.core.effect.PeriodicForce;
import org.auvsim.core.effect.PivotFriction;
import org.auvsim.core.effect.StepForce;
import org.auvsim.core.effect.Tether;
import org.auvsim.core.effect.WaveForce;
import org.auvsim.core.field.AiryWave;
import org.auvsim.core.field.IrregularWaves;
import org.auvsim.core.field.LayeredTemperature;
import org.auvsim.core.field.MagneticDipoleField;
import org.auvsim.core.field.OscillatingCurrent;
import org.auvsim.core.field.ShearCurrent;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.field.UniformMagneticField;
import org.auvsim.core.field.VortexCurrent;
import org.auvsim.core.field.VortexProfile;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.Compass;
import org.auvsim.core.sensor.Datum;
import org.auvsim.core.sensor.DepthSensor;
import org.auvsim.core.sensor.Dvl;
import org.auvsim.core.sensor.Gps;
import org.auvsim.core.sensor.Imu;
import org.auvsim.core.sensor.InertialErrors;
import org.auvsim.core.sensor.Magnetometer;
import org.auvsim.core.sensor.RangeSonar;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.sensor.Thermometer;
import org.auvsim.core.sensor.VectorErrors;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;

/**
 * Numbers that mean nothing are refused by sentences that say whose, which, the range, the value.
 */
class RefusedNumbersTest {
    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Quat UP = Quat.IDENTITY;
    private static final ScalarErrors EXACT = ScalarErrors.NONE;
    private static final VectorErrors EXACTLY = VectorErrors.NONE;
    private static final Sampling AT = Sampling.at(1);
    private static final OptionalDouble ONE = OptionalDouble.of(1);
    private static final Propulsor SCREW = new Propulsor("x", 1, 0, Vec3.ZERO, X);
    private static final Fin FIN =
            new Fin(
                    "x",
                    1,
                    1,
                    Vec3.ZERO,
                    X,
                    Y,
                    0,
                    0,
                    0.35,
                    1025,
                    0,
                    0,
                    0.35,
                    ONE,
                    Optional.empty());

    /** What sentences call something, and one of it whose numbers are all good. */
    static Stream<Arguments> good() {
        return Stream.of(
                arguments("gravity", new Gravity(9.8)),
                arguments("buoyancy", new Buoyancy(1, 1025, 9.8, X, 0, ONE)),
                arguments("damping", new Damping(X, X, X, X)),
                arguments(
                        "damping of SURGE by SWAY",
                        new DampingTerm(MotionAxis.SURGE, MotionAxis.SWAY, 1, 1)),
                arguments("a hydrodynamic derivative", new Derivative("Yv", 1)),
                arguments("a central force", new CentralForce(1, 1, X)),
                arguments("a magnetic dipole", new MagneticDipole(X)),
                arguments("a Magnus force", new MagnusForce(1)),
                arguments("a Coulomb friction", new CoulombFriction(1, 1, 1)),
                arguments("a magnetic attraction", new MagneticAttraction(1, X, 1)),
                arguments("a periodic force", new PeriodicForce(X, X, 1)),
                arguments("a wave force", new WaveForce(1, 1, 1, 1, 1)),
                arguments("a step force", new StepForce(X, 1, 1)),
                arguments("a kick", new Kick(X, 1, 1)),
                arguments("anisotropic drag", new AnisotropicDrag(X)),
                arguments("isotropic drag", new IsotropicDrag(1, 1, 1)),
                arguments("the condition of a propulsor", Condition.SOUND.losing(0.5)),
                arguments("the failure of a propulsor", new Failure(1, 1, 1)),
                arguments("the sag of a propulsor", new Sag(1, 1)),
                arguments("a mooring", new Mooring(X, X, 1, 1, 1)),
                arguments("a tether", new Tether(1, X, X, 1, 1, 1)),
                arguments("a pivot friction", new PivotFriction(1, 1, 1)),
                arguments("a brake", new Brake(1, X, 1, 1)),
                arguments("propulsor 'x'", SCREW),
                arguments("fin 'x'", FIN),
                arguments("battery 'x'", new Battery("x", 2, 1)),
                arguments("what is drawn from battery 'x'", new PowerDraw("x", 1, 1, true)),
                arguments("a rotor", new Rotor(1, 1)),
                arguments("what an actuator has reached", new Reached(1, 1)),
                arguments("current 'x'", new UniformCurrent(1, "x", X)),
                arguments("current 'x'", new ShearCurrent(1, "x", X, 0, X)),
                arguments("current 'x'", new OscillatingCurrent(1, "x", X, X, 1, 0)),
                arguments(
                        "current 'x'",
                        new VortexCurrent(1, "x", 0, 0, 1, 1, VortexProfile.RANKINE)),
                arguments("wave 'x'", new AiryWave(1, "x", 0.01, 9, 0, 0, ONE, 0)),
                arguments("waves 'x'", new IrregularWaves(1, "x", 0.1, 9, 1, 0, 9, 1, ONE, 0)),
                arguments(
                        "temperature field 'x'", new LayeredTemperature(1, "x", 1, 1, 1, 1, 1, 1)),
                arguments("magnetic field 'x'", new UniformMagneticField(1, "x", X)),
                arguments("magnetic field 'x'", new MagneticDipoleField(1, "x", X, X, 1)),
                arguments("gps 'x'", new Gps("x", X, 0, 0, EXACTLY, AT)),
                arguments("compass 'x'", new Compass("x", UP, 0, EXACT, AT)),
                arguments("depth-sensor 'x'", new DepthSensor("x", X, 0, 1, 1, EXACT, AT)),
                arguments("dvl 'x'", new Dvl("x", X, UP, 0.5, 9, 1, EXACTLY, EXACT, AT)),
                arguments(
                        "imu 'x'",
                        new Imu("x", X, UP, 9.8, InertialErrors.NONE, InertialErrors.NONE, AT)),
                arguments("magnetometer 'x'", new Magnetometer("x", X, UP, EXACTLY, AT)),
                arguments("range-sonar 'x'", new RangeSonar("x", X, UP, 3, 1, 0, 9, EXACT, AT)),
                arguments("thermometer 'x'", new Thermometer("x", X, EXACT, AT)),
                arguments("a sensor", new Sampling(1, 0, 0, 0)),
                arguments("a sensor", EXACT),
                arguments("a sensor", EXACTLY),
                arguments("a sensor", InertialErrors.NONE),
                arguments("a datum", new Datum(1, 1, 1)),
                arguments("radio 'x'", new Radio("x", X, "1", 9, 0, 0, 0, 0)),
                arguments("acoustic-modem 'x'", new AcousticModem("x", X, "1", 9, 1500, 0, 0)));
    }

    @ParameterizedTest(name = "{1}")
    @MethodSource("good")
    void noNumberMayBeInfiniteOrMissing(String of, Record good) throws Exception {
        RecordComponent[] parts = good.getClass().getRecordComponents();
        int numbers = 0;
        for (int i = 0; i < parts.length; i++) {
            for (double bad :
                    new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
                for (Object value : asA(parts[i].getType(), bad)) {
                    assertThat(refusal(good, i, value))
                            .as("%s = %s", parts[i].getName(), value)
                            .startsWith("the ")
                            .containsPattern(
                                    " of \\Q" + of + "\\E must be .+, but is .*\\Q" + bad + "\\E");
                    numbers++;
                }
            }
        }
        assertThat(numbers).isPositive();
    }

    /** A value of a parameter's type in which a number is bad; none for types without numbers. */
    private static List<Object> asA(Class<?> type, double bad) {
        if (type == double.class) {
            return List.of(bad);
        }
        if (type == OptionalDouble.class) {
            return List.of(OptionalDouble.of(bad));
        }
        if (type == Vec3.class) {
            return List.of(new Vec3(bad, 0, 0), new Vec3(0, bad, 0), new Vec3(0, 0, bad));
        }
        return type == Quat.class ? List.of(new Quat(1, bad, 0, 0)) : List.of();
    }

    /** The sentence by which a copy with another value is refused. */
    private static String refusal(Record good, int part, Object value) throws Exception {
        RecordComponent[] parts = good.getClass().getRecordComponents();
        List<Object> values = new ArrayList<>();
        for (RecordComponent each : parts) {
            values.add(each.getAccessor().invoke(good));
        }
        values.set(part, value);
        Constructor<?> constructor =
                good.getClass()
                        .getDeclaredConstructor(
                                Arrays.stream(parts)
                                        .map(RecordComponent::getType)
                                        .toArray(Class<?>[]::new));
        try {
            return "not refused: " + constructor.newInstance(values.toArray());
        } catch (InvocationTargetException e) {
            return String.valueOf(Objects.requireNonNull(e.getCause()).getMessage());
        }
    }

    static Stream<Arguments> outside() {
        return Stream.of(
                outside(
                        () -> new Gravity(-1),
                        "acceleration of gravity must be 0 m/s^2 or more and finite, but is -1.0"
                                + " m/s^2"),
                outside(
                        () -> new CentralForce(-1, 0.1, X),
                        "force of a central force must be 0 N or more and finite, but is -1.0 N"),
                outside(
                        () -> new CentralForce(1, -0.1, X),
                        "rest radius of a central force must be 0 m or more and finite, but is"
                                + " -0.1 m"),
                outside(
                        () -> new Damping(X, new Vec3(0, -1, 0), X, X),
                        "quadratic coefficient of SWAY of damping must be 0 N s^2/m^2 or more and"
                                + " finite, but is -1.0 N s^2/m^2"),
                outside(
                        () -> new Damping(X, X, new Vec3(0, 0, -1), X),
                        "linear coefficient of YAW of damping must be 0 N m s/rad or more and"
                                + " finite, but is -1.0 N m s/rad"),
                outside(
                        () -> new Battery("x", 0, 0),
                        "capacity of battery 'x' must be above 0 J and finite, but is 0.0 J"),
                outside(
                        () -> new Battery("x", 5, 6),
                        "charge of battery 'x' must be 0 to its capacity of 5.0 J, but is 6.0 J"),
                outside(
                        () -> new PowerDraw("x", -1, 0, true),
                        "maximum power of what is drawn from battery 'x' must be 0 W or more and"
                                + " finite, but is -1.0 W"),
                outside(
                        () -> new Rotor(-1, 1),
                        "inertia of a rotor must be 0 kg m^2 or more and finite, but is -1.0"
                                + " kg m^2"),
                outside(
                        () -> new PolynomialThrust(Numbers.of(1, Double.NaN)),
                        "coefficient 2 of a polynomial thrust must be finite, but is NaN N"),
                outside(
                        () ->
                                new ThrustTable(
                                        List.of(new ThrustPoint(-1, -1), new ThrustPoint(2, 2))),
                        "level of point 2 of a thrust table must be -1.0 to 1.0, but is 2.0"),
                outside(
                        () -> new Propulsor("x", 1, 0, X, Vec3.ZERO),
                        "direction of propulsor 'x' must be finite and not zero, but is"
                                + " (0.0, 0.0, 0.0)"),
                outside(
                        () -> new RangeSonar("x", X, UP, 3, Math.PI, 0, 9, EXACT, AT),
                        "fan of range-sonar 'x' must be 0 to below pi rad, but is"
                                + " 3.141592653589793 rad"),
                outside(
                        () -> new Radio("x", X, "1", 9, 0, -1, 0, 0),
                        "maximum-depth of radio 'x' must be 0 m or more and finite, but is -1.0"
                                + " m"));
    }

    private static Arguments outside(Runnable made, String sentence) {
        return arguments(made, "the " + sentence);
    }

    @ParameterizedTest(name = "{1}")
    @MethodSource("outside")
    void whatIsOutsideItsRangeIsRefused(Runnable made, String sentence) {
        assertThatIllegalArgumentException().isThrownBy(made::run).withMessage(sentence);
    }
}
