package org.auvsim.bench.peers;

import com.github.stephengold.joltjni.Body;
import com.github.stephengold.joltjni.BodyCreationSettings;
import com.github.stephengold.joltjni.BodyInterface;
import com.github.stephengold.joltjni.JobSystem;
import com.github.stephengold.joltjni.JobSystemSingleThreaded;
import com.github.stephengold.joltjni.JobSystemThreadPool;
import com.github.stephengold.joltjni.MapObj2Bp;
import com.github.stephengold.joltjni.MassProperties;
import com.github.stephengold.joltjni.ObjVsBpFilter;
import com.github.stephengold.joltjni.ObjVsObjFilter;
import com.github.stephengold.joltjni.PhysicsSettings;
import com.github.stephengold.joltjni.PhysicsSystem;
import com.github.stephengold.joltjni.Quat;
import com.github.stephengold.joltjni.RVec3;
import com.github.stephengold.joltjni.SphereShape;
import com.github.stephengold.joltjni.TempAllocator;
import com.github.stephengold.joltjni.TempAllocatorMalloc;
import com.github.stephengold.joltjni.Vec3;
import com.github.stephengold.joltjni.enumerate.EActivation;
import com.github.stephengold.joltjni.enumerate.EMotionType;
import com.github.stephengold.joltjni.enumerate.EOverrideMassProperties;

import org.auvsim.experiments.workload.Workload;

/** Jolt Physics, by way of jolt-jni, single precision, discrete collision detection. */
final class Jolt implements Peer {
    private static final int LAYER = 0;

    private final int threads;

    private final JobSystem jobs;

    private final TempAllocator allocator;

    /** On so many threads. */
    Jolt(int threads) {
        this.threads = threads;
        Natives.load("linux/x86-64/com/github/stephengold/libjoltjni.so");
        com.github.stephengold.joltjni.Jolt.registerDefaultAllocator();
        com.github.stephengold.joltjni.Jolt.installDefaultAssertCallback();
        com.github.stephengold.joltjni.Jolt.installDefaultTraceCallback();
        com.github.stephengold.joltjni.Jolt.newFactory();
        com.github.stephengold.joltjni.Jolt.registerTypes();
        allocator = new TempAllocatorMalloc();
        jobs =
                threads == 1
                        ? new JobSystemSingleThreaded(2048)
                        : new JobSystemThreadPool(2048, 8, threads - 1);
    }

    @Override
    public String name() {
        return "Jolt (jolt-jni 0.9.9)" + (threads == 1 ? "" : ", " + threads + " threads");
    }

    @Override
    public PeerWorld world(Workload workload) {
        return new Spheres(workload, jobs, allocator);
    }

    private static final class Spheres implements PeerWorld {
        private final PhysicsSystem system = new PhysicsSystem();
        private final TempAllocator allocator;
        private final JobSystem jobs;
        private final Body[] bodies;

        Spheres(Workload workload, JobSystem jobs, TempAllocator allocator) {
            this.jobs = jobs;
            this.allocator = allocator;
            int n = workload.bodies();
            system.init(
                    n,
                    0,
                    Math.max(1_000, 16 * n),
                    Math.max(1_000, 8 * n),
                    new MapObj2Bp(1, 1).add(LAYER, 0),
                    new ObjVsBpFilter(1, 1),
                    new ObjVsObjFilter(1));
            system.setGravity(0, 0, 0);
            PhysicsSettings settings = system.getPhysicsSettings();
            settings.setAllowSleeping(false);
            system.setPhysicsSettings(settings);
            bodies = new Body[n];
            BodyInterface all = system.getBodyInterface();
            SphereShape sphere = new SphereShape((float) Workload.RADIUS);
            MassProperties mass = new MassProperties().setMass((float) Workload.MASS);
            double[] places = workload.positions();
            for (int i = 0; i < n; i++) {
                BodyCreationSettings body =
                        new BodyCreationSettings(
                                sphere,
                                new RVec3(places[3 * i], places[3 * i + 1], places[3 * i + 2]),
                                new Quat(),
                                EMotionType.Dynamic,
                                LAYER);
                body.setFriction(0).setRestitution((float) workload.restitution());
                body.setLinearDamping(0).setAngularDamping(0).setAllowSleeping(false);
                body.setOverrideMassProperties(EOverrideMassProperties.CalculateInertia);
                body.setMassPropertiesOverride(mass);
                bodies[i] = all.createBody(body);
                body.close();
                all.addBody(bodies[i], EActivation.Activate);
            }
            system.optimizeBroadPhase();
        }

        @Override
        public void positions(double[] to) {
            for (int i = 0; i < bodies.length; i++) {
                RVec3 v = bodies[i].getPosition();
                to[3 * i] = v.xx();
                to[3 * i + 1] = v.yy();
                to[3 * i + 2] = v.zz();
            }
        }

        @Override
        public void velocities(double[] to) {
            for (int i = 0; i < bodies.length; i++) {
                Vec3 v = bodies[i].getLinearVelocity();
                to[3 * i] = v.getX();
                to[3 * i + 1] = v.getY();
                to[3 * i + 2] = v.getZ();
            }
        }

        @Override
        public void step(double[] forces, double dt) {
            Vec3 force = new Vec3();
            for (int i = 0; i < bodies.length; i++) {
                force.set(
                        (float) forces[3 * i],
                        (float) forces[3 * i + 1],
                        (float) forces[3 * i + 2]);
                bodies[i].addForce(force);
            }
            system.update((float) dt, 1, allocator, jobs);
        }

        @Override
        public void close() {
            system.removeAllBodies();
            for (Body body : bodies) {
                system.getBodyInterface().destroyBody(body.getId());
            }
            system.close();
        }
    }
}
