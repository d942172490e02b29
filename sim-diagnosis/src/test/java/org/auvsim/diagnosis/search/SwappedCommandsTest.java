package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.AsBelieved;
import org.auvsim.diagnosis.subject.MeasuredTorpedo;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;

/** A vehicle of which two thrusters were told what the other ones should have been. */
class SwappedCommandsTest {
    private static MeasuredRun run(Vec3 current) {
        return new Surveyor(0, current, 1, 0).run("run", new Random(4));
    }

    private static SwappedCommands of(BelievedModel model, MeasuredRun... of) {
        List<MeasuredRun> runs = List.of(of);
        Noise noise = Noise.of(runs);
        return new SwappedCommands(
                AsBelieved.followed(model, runs, noise),
                AsBelieved.fitted(model, runs, noise),
                noise,
                Course.UNHEARD);
    }

    private static Optional<String> notice(MeasuredRun... of) throws Exception {
        return of(Surveyor.believed(), of).nearest().map(SwappedCommands.Swap::notice);
    }

    private static Optional<String> surely(MeasuredRun... of) throws Exception {
        return of(Surveyor.believed(), of).certain().map(SwappedCommands.Swap::notice);
    }

    @Test
    void theTwoAreNamed() throws Exception {
        assertThat(notice(run(Vec3.ZERO).swapping("starboard", "vertical")))
                .hasValueSatisfying(
                        said ->
                                assertThat(said)
                                        .contains(
                                                "'vertical' and 'starboard' are swapped",
                                                "--rename vertical=starboard,starboard=vertical"));
    }

    /** Where nothing else is wrong that is sure before any cause was tried. */
    @Test
    void theSearchEndsBeforeItTriesCauses() throws Exception {
        List<MeasuredRun> runs = List.of(run(Vec3.ZERO).swapping("port", "starboard"));
        BelievedModel model = Surveyor.believed();
        Set<String> stages = new TreeSet<>();
        Progress heard =
                (stage, _) -> {
                    stages.add(stage);
                    return true;
                };
        Course course = new Course(heard);

        Search.Found found =
                new Search(model, runs, Library.of(model, runs), Way.THOROUGH, course).found();

        assertThat(found.misreading().notice())
                .hasValueSatisfying(
                        said -> assertThat(said).contains("'starboard' and 'port' are swapped"));
        assertThat(found.best().isNone()).isTrue();
        assertThat(stages).doesNotContain("fitting sets of causes");
    }

    @Test
    void otherMisfitsAreNoReasonToEndIt() throws Exception {
        assertThat(surely(run(Vec3.ZERO))).isEmpty();
        assertThat(surely(run(new Vec3(0, 0.3, 0)))).isEmpty();
        assertThat(surely(run(new Vec3(0, 0.3, 0)).swapping("port", "starboard"))).isEmpty();
    }

    @Test
    void somethingElseMayBeWrongToo() throws Exception {
        assertThat(notice(run(new Vec3(0, 0.03, 0)).swapping("port", "starboard")))
                .hasValueSatisfying(
                        said -> assertThat(said).contains("'starboard' and 'port' are swapped"));
    }

    @Test
    void otherMisfitsAreNotTakenForIt() throws Exception {
        assertThat(notice(run(Vec3.ZERO))).isEmpty();
        assertThat(notice(run(new Vec3(0, 0.3, 0)))).isEmpty();
        assertThat(notice(new Surveyor(0, Vec3.ZERO, 0.3, 0).run("weak", new Random(5)))).isEmpty();
    }

    /** With swapped thrusters it would turn as it is told to, and go elsewhere. */
    @Test
    void headingsAndRatesThatGrowTheOtherWayAreNotTakenForIt() throws Exception {
        MeasuredRun of = new Surveyor(0, Vec3.ZERO, 1, 0).runWithRate("run", new Random(6));

        assertThat(notice(of.turned(Quat::conjugate).spinning(w -> w.times(-1)))).isEmpty();
    }

    /** A rudder that goes to 0.35 rad cannot be told what a propeller was. */
    @Test
    void whatCannotDoTheSameIsNotSwapped() throws Exception {
        BelievedModel model = MeasuredTorpedo.model(MeasuredTorpedo.RUDDER);
        BelievedModel worn = MeasuredTorpedo.model(MeasuredTorpedo.WORN);
        SwappedCommands of = of(model, MeasuredTorpedo.run(worn, 1, 0, Vec3.ZERO));

        assertThat(of.nearest()).isEmpty();
        assertThat(of.certain()).isEmpty();
    }

    /** What a part began with was commanded before it. */
    @Test
    void partsAreSwappedWithTheirPast() {
        MeasuredRun part = run(Vec3.ZERO).part("part", 100, 200).swapping("port", "starboard");

        assertThat(part.commands().getFirst().name()).isEqualTo("starboard");
        assertThat(part.whole().commands().getFirst().name()).isEqualTo("starboard");
    }
}
