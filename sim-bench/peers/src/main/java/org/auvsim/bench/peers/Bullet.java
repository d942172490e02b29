package org.auvsim.bench.peers;

import com.jme3.bullet.PhysicsSpace;
import com.jme3.bullet.collision.shapes.SphereCollisionShape;
import com.jme3.bullet.objects.PhysicsRigidBody;
import com.jme3.math.Vector3f;

import org.auvsim.experiments.workload.Workload;

/** Bullet, by way of Libbulletjme, single precision, with its dynamic bounding-volume tree. */
final class Bullet implements Peer {
    Bullet() {
        Natives.load("native/linux/x86_64/libbulletjme.so");
        PhysicsRigidBody.logger2.setLevel(java.util.logging.Level.WARNING);
        PhysicsSpace.logger.setLevel(java.util.logging.Level.WARNING);
    }

    @Override
    public String name() {
        return "Bullet (Libbulletjme 23.1.0)";
    }

    @Override
    public PeerWorld world(Workload workload) {
        return new Spheres(workload);
    }

    private static final class Spheres implements PeerWorld {
        private final PhysicsSpace space = new PhysicsSpace(PhysicsSpace.BroadphaseType.DBVT);
        private final PhysicsRigidBody[] bodies;
        private final Vector3f vector = new Vector3f();

        Spheres(Workload workload) {
            space.setGravity(Vector3f.ZERO);
            bodies = new PhysicsRigidBody[workload.bodies()];
            SphereCollisionShape sphere = new SphereCollisionShape((float) Workload.RADIUS);
            double[] places = workload.positions();
            for (int i = 0; i < bodies.length; i++) {
                PhysicsRigidBody body = new PhysicsRigidBody(sphere, (float) Workload.MASS);
                body.setPhysicsLocation(
                        new Vector3f(
                                (float) places[3 * i],
                                (float) places[3 * i + 1],
                                (float) places[3 * i + 2]));
                body.setRestitution((float) workload.restitution());
                body.setFriction(0);
                body.setDamping(0, 0);
                body.setEnableSleep(false);
                space.addCollisionObject(body);
                body.setGravity(Vector3f.ZERO);
                bodies[i] = body;
            }
        }

        @Override
        public void positions(double[] to) {
            for (int i = 0; i < bodies.length; i++) {
                put(bodies[i].getPhysicsLocation(vector), to, i);
            }
        }

        @Override
        public void velocities(double[] to) {
            for (int i = 0; i < bodies.length; i++) {
                put(bodies[i].getLinearVelocity(vector), to, i);
            }
        }

        private static void put(Vector3f v, double[] to, int i) {
            to[3 * i] = v.x;
            to[3 * i + 1] = v.y;
            to[3 * i + 2] = v.z;
        }

        @Override
        public void step(double[] forces, double dt) {
            for (int i = 0; i < bodies.length; i++) {
                vector.set(
                        (float) forces[3 * i],
                        (float) forces[3 * i + 1],
                        (float) forces[3 * i + 2]);
                bodies[i].applyCentralForce(vector);
            }
            // 0 sub-steps: one step of just this length.
            space.update((float) dt, 0);
        }

        @Override
        public void close() {
            space.destroy();
        }
    }
}
