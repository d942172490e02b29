package org.auvsim.diagnosis.cause;

import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.effect.AnisotropicDrag;
import org.auvsim.core.effect.CoulombFriction;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.effect.Kick;
import org.auvsim.core.effect.MagneticAttraction;
import org.auvsim.core.effect.MagnusForce;
import org.auvsim.core.effect.PeriodicForce;
import org.auvsim.core.effect.PivotFriction;
import org.auvsim.core.effect.StepForce;
import org.auvsim.core.effect.WaveForce;
import org.auvsim.core.entity.Effect;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Effects that scenarios may state and no other cause covers, a user's own above all: those that a
 * scenario may state without any number, and then do nothing. What already acts then is no cause: a
 * little of it would be nearly all of it.
 */
final class EffectCauses {
    /** What causes of the library are made of. */
    private static final Set<Class<?>> COVERED =
            Set.of(
                    AnisotropicDrag.class,
                    CoulombFriction.class,
                    Damping.class,
                    IsotropicDrag.class,
                    Kick.class,
                    MagneticAttraction.class,
                    MagnusForce.class,
                    PeriodicForce.class,
                    PivotFriction.class,
                    StepForce.class,
                    WaveForce.class);

    private EffectCauses() {}

    static List<Cause> of(Setting s, ClassLoader loader) {
        AuvsmlMapper mapper = AuvsmlMapper.load(loader);
        List<Cause> causes = new ArrayList<>();
        for (Class<?> type : mapper.implementations(Effect.class).values()) {
            if (!COVERED.contains(type)) {
                mapper.withDefaults(type)
                        .map(effect -> new EffectNumbers((Effect) effect))
                        .filter(numbers -> numbers.mayBeAbsent(s))
                        .map(numbers -> cause(s, type, numbers))
                        .ifPresent(causes::add);
            }
        }
        return causes;
    }

    private static Cause cause(Setting s, Class<?> type, EffectNumbers numbers) {
        List<Parameter> parameters = numbers.parameters(s);
        double[] zeros = new double[parameters.size()];
        return Change.of(
                        ElementName.of(type).replace('-', '_'),
                        parameters,
                        (v, theta) -> v.with(b -> b.effect(numbers.effect(theta))))
                .from(List.of(Change.guess(parameters, zeros, numbers.strengths())));
    }
}
