package org.auvsim.examples.mine;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * The collision response of a mine: whatever touches it, it leaves the world, and a {@link
 * ShockWave} spreads from where it was.
 *
 * @param core radius at which the wave begins (m), less than the mine's own
 * @param speed of the wave's front (m/s); 1,500 is that of sound in water
 * @param reach radius at which the wave ends (m)
 * @param impulse that the wave gives at 1 m (N s)
 * @param damage that the wave does at 1 m (points of a {@link Hull})
 */
public record Mine(
        @Unit("m") @Default("0.1") double core,
        @Unit("m/s") @Default("1500.0") double speed,
        @Unit("m") double reach,
        @Unit("N s") double impulse,
        double damage)
        implements CollisionResponse {
    @Override
    public List<Change> respond(Contact contact) {
        Vec3 centre = contact.self().body().orElseThrow().state().position();
        return List.of(
                new Change.Remove(contact.self().id()),
                new Change.AddEntity(
                        id ->
                                new ShockWave(
                                        id,
                                        "Shock wave " + id,
                                        this,
                                        centre,
                                        contact.time(),
                                        List.of())));
    }
}
