package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.auvsim.diagnosis.cause.RigidBodyEquations.times;

import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.RotationConvention;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Load;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Now;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Push;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/** Each cause moves a body as docs/causes.md says, by equations written down once more here. */
class CauseEquationsTest {
    private static final double MASS = 12;
    private static final double G = 9.80665;
    private static final Vector3D INERTIA = new Vector3D(0.5, 0.9, 1.1);
    private static final int SAMPLES = 41;
    private static final double END = (SAMPLES - 1) * Tank.SPACING;
    private static final Vector3D U = new Vector3D(0.3, -0.2, 0.1);
    private static final Push NOTHING = now -> Load.force(Vector3D.ZERO);

    /** A model, numbers of a cause, and the equations of both together. */
    record Case(
            String id,
            String subject,
            String believed,
            List<Double> theta,
            RigidBodyEquations equations,
            double error) {
        @Override
        public String toString() {
            return subject.isEmpty() ? id : id + " (" + subject + ")";
        }
    }

    private static Case of(String id, String believed, Push push, double... theta) {
        return new Case(id, "", believed, numbers(theta), body(push), 2e-5);
    }

    private static List<Double> numbers(double... theta) {
        return DoubleStream.of(theta).boxed().toList();
    }

    private static RigidBodyEquations body(Push push) {
        return new RigidBodyEquations(new Vector3D(MASS, MASS, MASS), INERTIA, push);
    }

    private static Push force(Function<Now, Vector3D> force) {
        return now -> Load.force(force.apply(now));
    }

    private static Vector3D drag(double k, Vector3D v) {
        return v.scalarMultiply(-k * v.getNorm());
    }

    static Stream<Case> cases() {
        List<Case> cases = new ArrayList<>();
        cases.addAll(ofWater());
        cases.addAll(ofPlaceAndTime());
        cases.addAll(ofTheBody());
        cases.addAll(ofThrusters());
        cases.addAll(ofFins());
        return cases.stream();
    }

    private static List<Case> ofWater() {
        String dragged = "<isotropic-drag quadratic=\"5\"/>";
        return List.of(
                of("linear_drag", "", force(n -> n.velocity().scalarMultiply(-3)), 3),
                of("quadratic_drag", "", force(n -> drag(5, n.velocity())), 5),
                of(
                        "anisotropic_drag",
                        "",
                        force(
                                n -> {
                                    Vector3D v = n.toBody(n.velocity());
                                    return n.toWorld(
                                            new Vector3D(
                                                    -2 * Math.abs(v.getX()) * v.getX(),
                                                    -5 * Math.abs(v.getY()) * v.getY(),
                                                    -9 * Math.abs(v.getZ()) * v.getZ()));
                                }),
                        2,
                        5,
                        9),
                of("rotational_drag", "", n -> Load.torque(n.turning().scalarMultiply(-0.4)), 0.4),
                of(
                        "magnus",
                        "",
                        force(
                                n ->
                                        n.toWorld(n.turning())
                                                .crossProduct(n.velocity())
                                                .scalarMultiply(4)),
                        4),
                of(
                        "current_constant",
                        dragged,
                        force(n -> drag(5, n.velocity().subtract(U))),
                        0.3,
                        -0.2,
                        0.1),
                of(
                        "current_oscillating",
                        dragged,
                        force(
                                n ->
                                        drag(
                                                5,
                                                n.velocity()
                                                        .subtract(Math.sin(2 * n.time()), U)
                                                        .subtract(
                                                                0.4 * Math.cos(2 * n.time()),
                                                                Vector3D.PLUS_I))),
                        0.3,
                        -0.2,
                        0.1,
                        0.4,
                        0,
                        0,
                        2),
                of(
                        "current_shear",
                        dragged,
                        force(
                                n ->
                                        drag(
                                                5,
                                                n.velocity()
                                                        .subtract(
                                                                n.place().getZ(),
                                                                new Vector3D(0.2, -0.1, 0)))),
                        0.2,
                        -0.1),
                of(
                        "current_vortex",
                        dragged,
                        force(
                                n -> {
                                    double x = n.place().getX() - 1;
                                    double y = n.place().getY() + 2;
                                    double rate = 6 / (2 * Math.PI * (x * x + y * y + 0.25));
                                    return drag(
                                            5,
                                            n.velocity()
                                                    .subtract(
                                                            new Vector3D(-rate * y, rate * x, 0)));
                                }),
                        1,
                        -2,
                        6,
                        0.5));
    }

    private static List<Case> ofPlaceAndTime() {
        Vector3D source = new Vector3D(2, 0.5, -1);
        Vector3D push = new Vector3D(3, -2, 1);
        return List.of(
                of(
                        "magnetic",
                        "",
                        force(
                                n -> {
                                    Vector3D d = source.subtract(n.place());
                                    return d.scalarMultiply(7 / Math.pow(d.getNorm(), 5));
                                }),
                        2,
                        0.5,
                        -1,
                        7),
                of(
                        "tether_spring",
                        "",
                        force(
                                n -> {
                                    Vector3D d = source.subtract(n.place());
                                    double beyond = Math.max(0, d.getNorm() - 0.8);
                                    return d.scalarMultiply(6 * beyond / d.getNorm());
                                }),
                        2,
                        0.5,
                        -1,
                        0.8,
                        6),
                of(
                        "wave_forcing",
                        "",
                        force(
                                n -> {
                                    double c = Math.cos(0.7);
                                    double s = Math.sin(0.7);
                                    double k = 1.5 * 9 / G;
                                    double way = c * n.place().getX() + s * n.place().getY();
                                    double angle = 3 * n.time() - k * way;
                                    double size = 4 * Math.sin(angle) + 2 * Math.cos(angle);
                                    return new Vector3D(size * c, size * s, 0);
                                }),
                        4,
                        2,
                        0.7,
                        3,
                        1.5),
                of(
                        "periodic_force",
                        "",
                        force(
                                n ->
                                        push.scalarMultiply(Math.sin(4 * n.time()))
                                                .add(2 * Math.cos(4 * n.time()), Vector3D.PLUS_K)),
                        3,
                        -2,
                        1,
                        0,
                        0,
                        2,
                        4),
                loosely(
                        of(
                                "step_force",
                                "",
                                force(n -> n.time() > 0.92 ? push : Vector3D.ZERO),
                                3,
                                -2,
                                1,
                                0.92)),
                loosely(
                        of(
                                "impulse",
                                "",
                                force(n -> push.scalarMultiply(bump(n.time() - 1))),
                                3,
                                -2,
                                1,
                                1)));
    }

    /** Gauss' curve, a fiftieth of a second wide. */
    private static double bump(double x) {
        return Math.exp(-x * x / (2 * 0.02 * 0.02)) / (0.02 * Math.sqrt(2 * Math.PI));
    }

    /** What jumps is spread a little. */
    private static Case loosely(Case of) {
        return new Case(of.id, of.subject, of.believed, of.theta, of.equations, 1e-3);
    }

    private static List<Case> ofTheBody() {
        String falling = "<gravity/><isotropic-drag quadratic=\"5\"/>";
        Vector3D offset = new Vector3D(0.02, -0.01, 0.03);
        Push weight =
                n -> Load.force(new Vector3D(0, 0, -1.2 * MASS * G).add(drag(5, n.velocity())));
        return List.of(
                of("buoyancy_weight", "", force(n -> new Vector3D(0, 0, 4)), 4),
                of(
                        "cob_offset",
                        "",
                        n ->
                                Load.torque(
                                        offset.crossProduct(
                                                n.toBody(new Vector3D(0, 0, MASS * G)))),
                        0.02,
                        -0.01,
                        0.03),
                of(
                        "coulomb_friction",
                        "",
                        force(n -> n.velocity().normalize().scalarMultiply(-0.02 * MASS * G)),
                        0.02),
                new Case(
                        "mass_error",
                        "",
                        falling,
                        numbers(0.2),
                        new RigidBodyEquations(
                                new Vector3D(1.2 * MASS, 1.2 * MASS, 1.2 * MASS), INERTIA, weight),
                        2e-5),
                new Case(
                        "inertia_error",
                        "",
                        "",
                        numbers(0.4, -0.2, 0.1),
                        new RigidBodyEquations(
                                new Vector3D(MASS, MASS, MASS),
                                times(INERTIA, new Vector3D(1.4, 0.8, 1.1)),
                                NOTHING),
                        2e-5),
                new Case(
                        "added_mass",
                        "",
                        "",
                        numbers(3, 5, 8),
                        new RigidBodyEquations(
                                new Vector3D(MASS + 3, MASS + 5, MASS + 8), INERTIA, NOTHING),
                        2e-5));
    }

    /** Two of 20 N that are told 0.6 and 0.4 at time 0, in place of 0. */
    private static final String THRUSTERS =
            """
            <propulsor name="port" maximum-thrust="20"><position x="-0.4" y="0.15" z="0"/></propulsor>
            <propulsor name="starboard" maximum-thrust="20"><position x="-0.4" y="-0.15" z="0"/></propulsor>
            """;

    private static Load thrust(Now now, double side, Vector3D force) {
        Vector3D at = new Vector3D(-0.4, side, 0);
        return new Load(now.toWorld(force), at.crossProduct(force));
    }

    private static Push thrusts(Function<Now, Vector3D> port, Function<Now, Vector3D> starboard) {
        return n -> thrust(n, 0.15, port.apply(n)).plus(thrust(n, -0.15, starboard.apply(n)));
    }

    private static Vector3D ahead(double newtons) {
        return new Vector3D(newtons, 0, 0);
    }

    private static Case about(String subject, Case of) {
        return new Case(of.id, subject, of.believed, of.theta, of.equations, of.error);
    }

    /** A fin across the stream, which is attached at all angles of the run. */
    private static String fin(double area, double race, String span) {
        return """
        <fin name="rudder" area="%s" lift-slope="2" density="1000" race="%s" angle="0.2" stall-angle="1.5">
          <position x="-0.4" y="0" z="0"/>%s
        </fin>
        """
                .formatted(area, race, span);
    }

    private static final String UPRIGHT = "<span x=\"0\" y=\"0\" z=\"1\"/>";
    private static final String LEVEL = "<span x=\"0\" y=\"1\" z=\"0\"/>";

    /** The lift of that fin, if it stands upright. */
    private static Push lift(double area, double race) {
        Vector3D place = new Vector3D(-0.4, 0, 0);
        return n -> {
            Vector3D v =
                    n.toBody(n.velocity())
                            .add(n.turning().crossProduct(place))
                            .add(race, Vector3D.PLUS_I);
            double attack = 0.2 - Math.atan2(v.getY(), v.getX());
            double size = 0.5 * 1000 * area * Math.hypot(v.getX(), v.getY()) * 2 * attack;
            Vector3D force = new Vector3D(-v.getY(), v.getX(), 0).scalarMultiply(size);
            return new Load(n.toWorld(force), place.crossProduct(force));
        };
    }

    private static List<Case> ofFins() {
        double none = 1e-12;
        return List.of(
                about("rudder", of("fin_gain", fin(0.01, 0.3, UPRIGHT), lift(0.015, 0.3), 0.5)),
                about("rudder", of("fin_race", fin(0.01, 0.3, UPRIGHT), lift(0.01, 1), 0.7)),
                about(
                        "sway and yaw",
                        of(
                                "hull_lift",
                                fin(none, 0, UPRIGHT),
                                n -> {
                                    Vector3D v = n.toBody(n.velocity());
                                    double r = n.turning().getZ();
                                    double u = v.getX();
                                    return new Load(
                                            n.toWorld(
                                                    new Vector3D(
                                                            0, u * (-9 * v.getY() + 3 * r), 0)),
                                            new Vector3D(0, 0, u * (2 * v.getY() - 4 * r)));
                                },
                                -9,
                                3,
                                2,
                                -4)),
                about(
                        "heave and pitch",
                        of(
                                "hull_lift",
                                fin(none, 0, LEVEL),
                                n -> {
                                    Vector3D v = n.toBody(n.velocity());
                                    double q = n.turning().getY();
                                    double u = v.getX();
                                    return new Load(
                                            n.toWorld(
                                                    new Vector3D(
                                                            0, 0, u * (-9 * v.getZ() - 3 * q))),
                                            new Vector3D(0, u * (-2 * v.getZ() - 4 * q), 0));
                                },
                                -9,
                                -3,
                                -2,
                                -4)));
    }

    private static List<Case> ofThrusters() {
        Rotation yawed = new Rotation(Vector3D.PLUS_K, 0.3, RotationConvention.VECTOR_OPERATOR);
        return List.of(
                about(
                        "port",
                        of(
                                "thruster_gain",
                                THRUSTERS,
                                thrusts(n -> ahead(6), n -> ahead(8)),
                                -0.5)),
                of("thruster_gain", THRUSTERS, thrusts(n -> ahead(6), n -> ahead(4)), -0.5),
                of("thruster_deadzone", THRUSTERS, thrusts(n -> ahead(10), n -> ahead(6)), 0.1),
                of(
                        "thruster_lag",
                        THRUSTERS,
                        thrusts(
                                n -> ahead(12 * (1 - Math.exp(-n.time() / 0.5))),
                                n -> ahead(8 * (1 - Math.exp(-n.time() / 0.5)))),
                        0.5),
                about(
                        "starboard",
                        of(
                                "thruster_misalignment",
                                THRUSTERS,
                                thrusts(n -> ahead(12), n -> yawed.applyTo(ahead(8))),
                                0.3)),
                about(
                        "port",
                        loosely(
                                of(
                                        "thruster_loss",
                                        THRUSTERS,
                                        thrusts(
                                                n -> ahead(n.time() < 1.02 ? 12 : 3),
                                                n -> ahead(8)),
                                        0.75,
                                        1.02))));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("cases")
    void movesTheBodyAsItsEquationSays(Case c) {
        BelievedModel model = Tank.model("", c.believed());
        Cause cause =
                Library.of(model, List.of(commanded(Tank.run(model, SAMPLES)))).stream()
                        .filter(one -> one.id().equals(c.id()))
                        .filter(one -> one.subject().orElse("").equals(c.subject()))
                        .findFirst()
                        .orElseThrow();
        Variant variant =
                cause.in(model.variant(), c.theta().stream().mapToDouble(x -> x).toArray());
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        commanded(Tank.times(SAMPLES)),
                        0,
                        SAMPLES - 1,
                        List.of(new Ensemble.Entrant(variant, Tank.START)))[0];
        double[] expected = c.equations().after(END, start());
        double[] actual = numbers(motion[SAMPLES - 1]);
        for (int i = 0; i < expected.length; i++) {
            assertThat(Math.abs(actual[i] - expected[i])).as("number %s", i).isLessThan(c.error());
        }
    }

    /** The same run, in which the thrusters are told something. */
    private static MeasuredRun commanded(MeasuredRun run) {
        MeasuredRunBuilder told = MeasuredRun.named("told").commands(List.of("port", "starboard"));
        for (int k = 0; k < run.size(); k++) {
            told.at(run.time(k)).command(0, 0.6).command(1, 0.4);
            run.vector(Channel.POSITION, k).ifPresent(p -> told.position(p.x(), p.y(), p.z()));
            run.orientation(k).ifPresent(told::orientation);
        }
        return told.build();
    }

    private static double[] start() {
        return numbers(Tank.START);
    }

    private static double[] numbers(RigidMotion m) {
        var w = m.orientation().rotateInverse(m.angularVelocity());
        return new double[] {
            m.position().x(),
            m.position().y(),
            m.position().z(),
            m.orientation().w(),
            m.orientation().x(),
            m.orientation().y(),
            m.orientation().z(),
            m.velocity().x(),
            m.velocity().y(),
            m.velocity().z(),
            w.x(),
            w.y(),
            w.z()
        };
    }
}
