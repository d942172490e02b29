package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** A user's own effects and causes are candidates, too. */
class OwnCausesTest {
    private static final BelievedModel MODEL = Tank.bare();

    /** An effect of a user's: a pull toward the plane of a height, as of stratified water. */
    public record Stratification(
            @Unit("N/m") @Default("0.0") double stiffness,
            @Unit("m") @Default("0.0") double height,
            @Unit("N s/m") @Default("0.0") double damping,
            @Default("2.0") double exponent)
            implements BodyEffect {
        /** Refuses what would push away. */
        public Stratification {
            if (stiffness < 0) {
                throw new IllegalArgumentException("the stiffness must be 0 or more");
            }
        }

        @Override
        public void add(Block block, int i) {
            double above = block.position(i).z() - height;
            double force = -stiffness * above - damping * block.velocity(i).z();
            block.addForce(i, new Vec3(0, 0, force));
        }
    }

    /** An effect of a user's that acts as soon as a body has it: drag in air that stands still. */
    public record WindDrag(
            @Unit("N s/m") @Default("0.5") double area, @Unit("m/s") @Default("0 0 0") Vec3 wind)
            implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            block.addForce(i, block.velocity(i).minus(wind).times(-area));
        }
    }

    /** A cause of a user's: the body is larger than it is believed to be. */
    public static final class Growth implements CauseFamily {
        @Override
        public List<Cause> of(BelievedModel model, List<MeasuredRun> runs) {
            return List.of(new Grown());
        }
    }

    private static final class Grown implements Cause {
        @Override
        public String id() {
            return "growth";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Parameter.positive("share", "1", 0.1));
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            double mass = model.body().mass().orElseThrow();
            return model.with(b -> b.mass(mass * (1 + theta[0])));
        }
    }

    /** A class path with a user's provider files. */
    @TempDir private Path folder;

    private List<Cause> library() throws IOException {
        Path services = Files.createDirectories(folder.resolve("META-INF/services"));
        Files.writeString(
                services.resolve(Effect.class.getName()),
                Stratification.class.getName() + "\n" + WindDrag.class.getName());
        Files.writeString(services.resolve(CauseFamily.class.getName()), Growth.class.getName());
        ClassLoader loader =
                new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader());
        return Library.of(MODEL, List.of(Tank.run(MODEL, 40)), loader);
    }

    private Cause named(String id) throws IOException {
        return library().stream().filter(cause -> cause.id().equals(id)).findFirst().orElseThrow();
    }

    @Test
    void anEffectIsACandidateByItsNumbersThatAreZero() throws IOException {
        Cause cause = named("stratification");

        assertThat(cause.parameters())
                .extracting(Parameter::name, Parameter::unit, Parameter::lowest)
                .containsExactly(
                        tuple("stiffness", "N/m", 0.0),
                        tuple("height", "m", Double.NEGATIVE_INFINITY),
                        tuple("damping", "N s/m", Double.NEGATIVE_INFINITY));
        assertThat(cause.guesses(List.of()))
                .singleElement()
                .extracting(Guess::columns)
                .isEqualTo(List.of(0, 2));
        Variant found = cause.in(MODEL.variant(), new double[] {3, 1.5, 0.2});
        Effect expected = new Stratification(3, 1.5, 0.2, 2);
        assertThat(found.body().effect()).containsExactly(expected);
    }

    @Test
    void anEffectThatActsWithoutAnyNumberIsNoCandidate() throws IOException {
        assertThat(library()).extracting(Cause::id).doesNotContain("wind_drag");
    }

    @Test
    void aFamilyOfCausesIsFound() throws IOException {
        Cause cause = named("growth");
        Variant found = cause.in(MODEL.variant(), new double[] {0.5});
        assertThat(found.body().mass()).hasValue(18);
    }

    @Test
    void whatTheLibraryCoversIsNoCandidateTwice() throws IOException {
        assertThat(library().stream().map(Cause::toString))
                .doesNotContain("isotropic_drag", "kick", "magnetic_attraction")
                .doesNotHaveDuplicates();
    }
}
