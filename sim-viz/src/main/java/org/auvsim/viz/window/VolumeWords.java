package org.auvsim.viz.window;

import org.auvsim.core.description.ElementName;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Compound;
import org.auvsim.core.volume.HeightMap;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.viz.scene.Counted;

import java.math.BigDecimal;
import java.math.MathContext;

/** A volume and its measures, as a scenario states them, in words. */
final class VolumeWords {
    private static final MathContext DIGITS = new MathContext(3);

    private VolumeWords() {}

    static String of(Volume volume) {
        return ElementName.of(volume.getClass())
                + switch (volume) {
                    case Sphere sphere -> ", radius %s m".formatted(length(sphere.radius()));
                    case Capsule capsule ->
                            ", radius %s m, length %s m"
                                    .formatted(length(capsule.radius()), length(capsule.length()));
                    case Box box -> " " + sides(box.size()) + " m";
                    case Compound compound -> " of " + Counted.of(compound.part().size(), "part");
                    case HeightMap map ->
                            " of %d by %d heights, %s m apart"
                                    .formatted(
                                            map.row().size(),
                                            map.row().getFirst().heights().size(),
                                            length(map.spacing()));
                    default ->
                            volume.isBounded()
                                    ? ", reaches %s m".formatted(length(volume.boundingRadius()))
                                    : "";
                };
    }

    private static String sides(Vec3 size) {
        return "%s x %s x %s".formatted(length(size.x()), length(size.y()), length(size.z()));
    }

    private static String length(double metres) {
        BigDecimal rounded = new BigDecimal(metres).round(DIGITS).stripTrailingZeros();
        return rounded.toPlainString();
    }
}
