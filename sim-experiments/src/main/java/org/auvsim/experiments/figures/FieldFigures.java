package org.auvsim.experiments.figures;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.MagneticField;
import org.auvsim.core.field.AiryWave;
import org.auvsim.core.field.GriddedCurrent;
import org.auvsim.core.field.IrregularWaves;
import org.auvsim.core.field.LayeredTemperature;
import org.auvsim.core.field.MagneticDipoleField;
import org.auvsim.core.field.OscillatingCurrent;
import org.auvsim.core.field.ShearCurrent;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.field.VortexCurrent;
import org.auvsim.core.field.VortexProfile;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.OptionalDouble;

/** A figure for each field. */
final class FieldFigures {
    private static final String TIME = "time (s)";
    private static final String DEPTH = "height (m)";
    private static final String ALONG = "u (m/s)";

    private FieldFigures() {}

    static List<Figure> all() {
        return List.of(
                uniformCurrent(),
                shearCurrent(),
                oscillatingCurrent(),
                vortexCurrent(),
                griddedCurrent(),
                waves(),
                underWaves(),
                magneticDipoleField(),
                layeredTemperature());
    }

    private static Figure uniformCurrent() {
        return new Figure(
                "uniform-current",
                "A body of 10 kg with damping of 5 N s/m in a current of 0.5 m/s",
                TIME,
                "velocity (m/s)",
                List.of(
                        drifting("body", new UniformCurrent(2, "stream", new Vec3(0.5, 0, 0))),
                        Series.of("water", 0, 10, _ -> 0.5)));
    }

    private static Series drifting(String name, Current current) {
        Vec3 linear = new Vec3(5, 5, 5);
        Damping damping = new Damping(linear, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);
        return Trial.of(Trial.ball(damping)).in(current).overTime(name, b -> b.velocity().x());
    }

    private static Figure shearCurrent() {
        Current shear =
                new ShearCurrent(1, "shear", new Vec3(0.6, 0, 0), 0, new Vec3(0.02, -0.01, 0));
        return new Figure(
                "shear-current",
                "0.6 m/s at the surface, and how it changes with height",
                DEPTH,
                "velocity (m/s)",
                List.of(
                        Series.of("u", -40, 0, z -> at(shear, 0, z).x()),
                        Series.of("v", -40, 0, z -> at(shear, 0, z).y())));
    }

    private static Vec3 at(Current current, double x, double z) {
        return current.valueAt(new Vec3(x, 0, z), 0);
    }

    private static Figure oscillatingCurrent() {
        Current tide =
                new OscillatingCurrent(2, "tide", new Vec3(0.2, 0, 0), new Vec3(0.4, 0, 0), 4, 0);
        return new Figure(
                "oscillating-current",
                "Water that swings with a period of 4 s, and a body that follows",
                TIME,
                ALONG,
                List.of(
                        Series.of("water", 0, 10, t -> tide.valueAt(Vec3.ZERO, t).x()),
                        drifting("body", tide)));
    }

    private static Figure vortexCurrent() {
        return new Figure(
                "vortex-current",
                "A circulation of 6 m^2/s about a core of 1.5 m",
                "distance from the axis (m)",
                "speed (m/s)",
                List.of(vortex(VortexProfile.LAMB_OSEEN), vortex(VortexProfile.RANKINE)));
    }

    private static Series vortex(VortexProfile profile) {
        Current vortex = new VortexCurrent(1, "vortex", 0, 0, 6, 1.5, profile);
        return Series.of(profile.name(), 0, 8, r -> at(vortex, r, 0).y());
    }

    private static Figure griddedCurrent() {
        Numbers one = Numbers.of(0);
        Numbers none = Numbers.of(0, 0, 0, 0);
        Current grid =
                new GriddedCurrent(
                        1,
                        "bay",
                        Numbers.of(0, 10, 25, 40),
                        one,
                        one,
                        Numbers.of(0.2, 0.5, 0.4, 0.1),
                        none,
                        none);
        return new Figure(
                "gridded-current",
                "Velocities at 0, 10, 25 and 40 m, and what is between and beyond",
                "x (m)",
                ALONG,
                List.of(Series.of("u", -10, 50, x -> at(grid, x, 0).x())));
    }

    private static Figure waves() {
        Current swell = new AiryWave(1, "swell", 1, 8, 0, 0, OptionalDouble.empty(), 0);
        Current sea = sea();
        return new Figure(
                "waves",
                "The surface over a place: a wave of 8 s, and a sea of Hs 2 m, Tp 8 s, gamma 3.3",
                TIME,
                "elevation (m)",
                List.of(
                        Series.of("airy-wave", 0, 60, t -> swell.elevation(0, 0, t)),
                        Series.of("irregular-waves", 0, 60, t -> sea.elevation(0, 0, t))));
    }

    private static Current sea() {
        return new IrregularWaves(1, "sea", 2, 8, 3.3, 0, 40, 1, OptionalDouble.empty(), 0)
                .prepared();
    }

    private static Figure underWaves() {
        return new Figure(
                "waves-below",
                "Velocity under the crest of a wave of 1 m and 8 s, by depth of the water",
                DEPTH,
                ALONG,
                List.of(
                        underCrest("deep", OptionalDouble.empty()),
                        underCrest("20 m", OptionalDouble.of(20)),
                        underCrest("8 m", OptionalDouble.of(8))));
    }

    private static Series underCrest(String name, OptionalDouble depth) {
        Current wave = new AiryWave(1, "wave", 1, 8, 0, 0, depth, 0).prepared();
        return Series.of(name, -depth.orElse(30), 0, z -> at(wave, 0, z).x());
    }

    private static Figure magneticDipoleField() {
        MagneticField wreck =
                new MagneticDipoleField(1, "wreck", Vec3.ZERO, new Vec3(0, 0, 1e5), 2);
        return new Figure(
                "magnetic-dipole-field",
                "A magnetised ball of 2 m and 100,000 A m^2, over its centre and beside it",
                "distance (m)",
                "vertical flux density (microtesla)",
                List.of(
                        Series.of(
                                "over", 0, 10, r -> 1e6 * wreck.valueAt(new Vec3(0, 0, r), 0).z()),
                        Series.of(
                                "beside",
                                0,
                                10,
                                r -> 1e6 * wreck.valueAt(new Vec3(r, 0, 0), 0).z())));
    }

    private static Figure layeredTemperature() {
        LayeredTemperature water = new LayeredTemperature(1, "Baltic", 18, 0.02, 10, 20, 8, 0);
        return new Figure(
                "layered-temperature",
                "18 degrees at the surface, 10 K less below a thermocline at 20 m",
                DEPTH,
                "temperature (degrees Celsius)",
                List.of(Series.of("water", -50, 0, z -> water.valueAt(new Vec3(0, 0, z), 0))));
    }
}
