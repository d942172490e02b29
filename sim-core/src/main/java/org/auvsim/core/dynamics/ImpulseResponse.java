package org.auvsim.core.dynamics;

import org.auvsim.core.entity.BodyMotion;
import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * The default response: a bounce by an impulse along the normal, without friction (Witkin &amp;
 * Baraff 1997, part II, section 8):
 *
 * <pre>j = -(1 + e) v_n / (1/mA + 1/mB + n . (IA^-1 (rA x n)) x rA + n . (IB^-1 (rB x n)) x rB)
 * </pre>
 *
 * <p>The restitution e is the smaller one of the two bodies. What is no body, such as a wave, is
 * not answered. Each side computes its own half; the halves are opposite to the bit.
 */
public record ImpulseResponse() implements CollisionResponse {
    @Override
    public List<Change> respond(Contact contact) {
        if (contact.self().body().isEmpty() || contact.other().body().isEmpty()) {
            return List.of();
        }
        BodyMotion self = contact.self().body().get();
        double j = impulse(contact, self, contact.other().body().get());
        if (j == 0) {
            return List.of();
        }
        Vec3 linear = contact.normal().times(j);
        Vec3 angular = contact.point().minus(self.state().position()).cross(linear);
        return List.of(new Change.Momentum(contact.self().id(), linear, angular));
    }

    /** Size of the impulse (N s) that parts the two; 0 if they part already or both are fixed. */
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
        Vec3 spin = body.inverseInertia().times(r.cross(n));
        return body.inverseMass() + n.dot(spin.cross(r));
    }
}
