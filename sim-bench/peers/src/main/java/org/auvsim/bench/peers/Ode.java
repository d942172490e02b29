package org.auvsim.bench.peers;

import org.auvsim.experiments.workload.Workload;
import org.ode4j.math.DVector3C;
import org.ode4j.ode.DBody;
import org.ode4j.ode.DContact;
import org.ode4j.ode.DContactBuffer;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DJointGroup;
import org.ode4j.ode.DMass;
import org.ode4j.ode.DSpace;
import org.ode4j.ode.DSphere;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeConstants;
import org.ode4j.ode.OdeHelper;

/** ode4j, a translation of the Open Dynamics Engine into Java, with its quick stepper. */
final class Ode implements Peer {
    @Override
    public String name() {
        return "ode4j 0.5.3";
    }

    @Override
    public PeerWorld world(Workload workload) {
        return new Spheres(workload);
    }

    private static final class Spheres implements PeerWorld {
        private final double restitution;
        private final DWorld world;
        private final DSpace space;
        private final DJointGroup contacts = OdeHelper.createJointGroup();
        private final DContactBuffer found = new DContactBuffer(1);
        private final DBody[] bodies;

        Spheres(Workload workload) {
            OdeHelper.initODE2(0);
            restitution = workload.restitution();
            world = OdeHelper.createWorld();
            world.setGravity(0, 0, 0);
            world.setAutoDisableFlag(false);
            space = OdeHelper.createHashSpace();
            bodies = new DBody[workload.bodies()];
            DMass mass = OdeHelper.createMass();
            mass.setSphereTotal(Workload.MASS, Workload.RADIUS);
            double[] places = workload.positions();
            for (int i = 0; i < bodies.length; i++) {
                bodies[i] = OdeHelper.createBody(world);
                bodies[i].setMass(mass);
                bodies[i].setPosition(places[3 * i], places[3 * i + 1], places[3 * i + 2]);
                DSphere sphere = OdeHelper.createSphere(space, Workload.RADIUS);
                sphere.setBody(bodies[i]);
            }
        }

        @Override
        public void positions(double[] to) {
            for (int i = 0; i < bodies.length; i++) {
                put(bodies[i].getPosition(), to, i);
            }
        }

        @Override
        public void velocities(double[] to) {
            for (int i = 0; i < bodies.length; i++) {
                put(bodies[i].getLinearVel(), to, i);
            }
        }

        private static void put(DVector3C v, double[] to, int i) {
            to[3 * i] = v.get0();
            to[3 * i + 1] = v.get1();
            to[3 * i + 2] = v.get2();
        }

        @Override
        public void step(double[] forces, double dt) {
            for (int i = 0; i < bodies.length; i++) {
                bodies[i].addForce(forces[3 * i], forces[3 * i + 1], forces[3 * i + 2]);
            }
            OdeHelper.spaceCollide(space, this, (_, a, b) -> touch(a, b));
            world.quickStep(dt);
            contacts.empty();
        }

        private void touch(DGeom a, DGeom b) {
            if (OdeHelper.collide(a, b, 1, found.getGeomBuffer()) > 0) {
                DContact contact = found.get(0);
                contact.surface.mode = OdeConstants.dContactBounce;
                contact.surface.mu = 0;
                contact.surface.bounce = restitution;
                contact.surface.bounce_vel = 0;
                OdeHelper.createContactJoint(world, contacts, contact)
                        .attach(a.getBody(), b.getBody());
            }
        }

        @Override
        public void close() {
            contacts.destroy();
            space.destroy();
            world.destroy();
            OdeHelper.closeODE();
        }
    }
}
