package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Compound;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Part;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.util.List;

class VolumeWordsTest {
    @Test
    void tellTheMeasuresThatAScenarioStates() {
        assertThat(VolumeWords.of(new Capsule(0.0955, 1.1417)))
                .isEqualTo("capsule, radius 0.0955 m, length 1.14 m");
        assertThat(VolumeWords.of(new Box(new Vec3(21, 11, 0.5)))).isEqualTo("box 21 x 11 x 0.5 m");
        assertThat(VolumeWords.of(new Sphere(1200))).isEqualTo("sphere, radius 1200 m");
        assertThat(VolumeWords.of(new HalfSpace())).isEqualTo("half-space");
        Part part = new Part(new Sphere(1), Vec3.ZERO, Quat.IDENTITY);
        assertThat(VolumeWords.of(new Compound(List.of(part, part))))
                .isEqualTo("compound of 2 parts");
        assertThat(VolumeWords.of(new Compound(List.of(part)))).isEqualTo("compound of 1 part");
    }
}
