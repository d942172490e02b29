package org.auvsim.core.sensor;

import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Field;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/** A world with nothing in it. */
final class StillScene implements Scene {
    @Override
    public Optional<Datum> datum() {
        return Optional.empty();
    }

    @Override
    public <F extends Field<?>> List<F> fields(Class<F> type) {
        return List.of();
    }

    @Override
    public List<Current> currents() {
        return List.of();
    }

    @Override
    public <C extends Component> List<C> components(Class<C> type) {
        return List.of();
    }

    @Override
    public Optional<Sighting> look(Vec3 from, Vec3 direction, double range, Target what) {
        return Optional.empty();
    }
}
