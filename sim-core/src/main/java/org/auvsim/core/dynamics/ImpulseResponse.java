package org.auvsim.core.dynamics;

import org.auvsim.core.contact.ContactBodies;
import org.auvsim.core.contact.ContactSolver;
import org.auvsim.core.contact.Contacts;
import org.auvsim.core.entity.BodyMotion;
import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * The default response: a bounce by an impulse along the normal (Witkin &amp; Baraff 1997, part II,
 * section 8):
 *
 * <pre>j = -(1 + e) v_n / (1/mA + 1/mB + n . (IA^-1 (rA x n)) x rA + n . (IB^-1 (rB x n)) x rB)
 * </pre>
 *
 * <p>The restitution e is the smaller one of the two bodies. The friction is the geometric mean;
 * where there is some, a {@link ContactSolver} finds both parts of the impulse, and energy never
 * grows. What is no body, such as a wave, is not answered. Each side computes its own half; the
 * halves are opposite to the bit.
 */
public record ImpulseResponse() implements CollisionResponse {
    @Override
    public List<Change> respond(Contact contact) {
        if (contact.self().body().isEmpty() || contact.other().body().isEmpty()) {
            return List.of();
        }
        BodyMotion self = contact.self().body().get();
        BodyMotion other = contact.other().body().get();
        double j = impulse(contact, self, other);
        if (j == 0) {
            return List.of();
        }
        Vec3 linear =
                self.friction() * other.friction() > 0
                        ? withFriction(contact, self, other)
                        : contact.normal().times(j);
        Vec3 angular = contact.point().minus(self.state().position()).cross(linear);
        return List.of(new Change.Momentum(contact.self().id(), linear, angular));
    }

    /**
     * Size of the impulse (N s) along the normal that parts the two, without friction; 0 if they
     * part already or both are fixed.
     */
    public static double impulse(Contact contact, BodyMotion a, BodyMotion b) {
        double separation = contact.separationSpeed();
        double yielding = yielding(a, contact) + yielding(b, contact);
        if (separation >= 0 || yielding == 0) {
            return 0;
        }
        double restitution = Math.min(a.restitution(), b.restitution());
        return -(1 + restitution) * separation / yielding;
    }

    /** How much speed along the normal a unit impulse at the contact gives a body (1/kg). */
    private static double yielding(BodyMotion body, Contact contact) {
        Vec3 n = contact.normal();
        Vec3 r = contact.point().minus(body.state().position());
        return n.dot(body.mobility().velocityAt(r, n));
    }

    /** The impulse (N s) on self. Always solved from the side of the lower id: the same bits. */
    private static Vec3 withFriction(Contact contact, BodyMotion self, BodyMotion other) {
        return contact.self().id() <= contact.other().id()
                ? solved(contact, self, other)
                : solved(contact.flipped(), other, self).negated();
    }

    private static Vec3 solved(Contact contact, BodyMotion a, BodyMotion b) {
        ContactBodies bodies = new ContactBodies();
        add(a, bodies);
        add(b, bodies);
        Contacts contacts = new Contacts();
        Vec3 p = contact.point();
        Vec3 n = contact.normal();
        int c = contacts.add(0, 1, p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
        contacts.friction[c] = Math.sqrt(a.friction() * b.friction());
        contacts.target[c] =
                -Math.min(a.restitution(), b.restitution()) * contact.separationSpeed();
        ContactSolver.forImpacts().solve(bodies, contacts);
        return n.times(contacts.jn[c])
                .plus(new Vec3(contacts.jx[c], contacts.jy[c], contacts.jz[c]));
    }

    private static void add(BodyMotion body, ContactBodies bodies) {
        Vec3 origin = body.state().position();
        int i = bodies.add(origin.x(), origin.y(), origin.z());
        int v = ContactBodies.SPEEDS * i;
        bodies.v[v] = body.velocity().x();
        bodies.v[v + 1] = body.velocity().y();
        bodies.v[v + 2] = body.velocity().z();
        bodies.v[v + 3] = body.angularVelocity().x();
        bodies.v[v + 4] = body.angularVelocity().y();
        bodies.v[v + 5] = body.angularVelocity().z();
        body.mobility().write(bodies.k, ContactBodies.RESPONSES * i);
    }
}
