package org.auvsim.diagnosis;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;

import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;

/** A sphere that is pushed about, with a force that its model lacks; it is integrated here. */
public record PushedSphere(Law law) {
    private static final double MASS = 10;
    private static final double NOISE = 0.002;
    private static final double INTERVAL = 0.1;
    private static final int SAMPLES = 200;
    private static final int SUBSTEPS = 1000;

    /** The force (N, world) that is hidden. */
    public interface Law {
        double[] force(double[] position, double[] velocity);
    }

    /** Without the force. */
    public static BelievedModel model() {
        World world =
                World.builder()
                        .timeStep(INTERVAL)
                        .add(
                                WorldObjectDefinition.named("sphere")
                                        .volume(new Sphere(0.2))
                                        .mass(MASS)
                                        .force(NamedForce.direct("push", Frame.WORLD, Vec3.ZERO))
                                        .build())
                        .build();
        return new BelievedModel(Scenario.of(world), "sphere");
    }

    /** Under pushes that change every 2 s, as drawn by a seed. */
    public MeasuredRun run(long seed) {
        SplittableRandom lot = new SplittableRandom(seed);
        MeasuredRunBuilder run =
                MeasuredRun.named("run " + seed).commands(List.of("push.x", "push.y", "push.z"));
        double[] p = new double[3];
        double[] v = new double[3];
        double[] push = new double[3];
        for (int k = 0; k < SAMPLES; k++) {
            run.at(k * INTERVAL).orientation(Quat.IDENTITY);
            run.position(
                    p[0] + NOISE * lot.nextGaussian(),
                    p[1] + NOISE * lot.nextGaussian(),
                    p[2] + NOISE * lot.nextGaussian());
            for (int i = 0; i < 3; i++) {
                push[i] = k % 20 == 0 ? 20 * (2 * lot.nextDouble() - 1) : push[i];
                run.command(i, push[i]);
            }
            move(p, v, push);
        }
        return run.build();
    }

    private void move(double[] p, double[] v, double[] push) {
        double h = INTERVAL / SUBSTEPS;
        for (int j = 0; j < SUBSTEPS; j++) {
            double[] force = law.force(p, v);
            for (int i = 0; i < 3; i++) {
                double a = (push[i] + force[i]) / MASS;
                p[i] += h * v[i] + h * h / 2 * a;
                v[i] += h * a;
            }
        }
    }

    /** Two runs to search these causes with, one held out. */
    public Investigation investigation(long seed, Set<String> causes) {
        BelievedModel model = model();
        List<MeasuredRun> fit = List.of(run(seed), run(seed + 1));
        List<Cause> candidates =
                Library.of(model, fit).stream().filter(c -> causes.contains(c.name())).toList();
        return new Investigation(
                model, fit, List.of(run(seed + 2)), candidates, seed, Progress.SILENT);
    }
}
