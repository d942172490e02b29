package org.auvsim.experiments.hidden;

import java.util.List;

/** A kind of body with what is done with it. */
interface Body {
    /** All kinds. */
    List<Body> ALL =
            List.of(
                    new BallInAir(),
                    new SphereInWater(),
                    new PushedBox(),
                    new Rov(),
                    new TorpedoAuv());

    String name();

    /** As it is believed. */
    Plant plant(Draws draws);

    /** Time step (s) with which the simulator follows it well. */
    double timeStep();

    /** Whether its orientation is measured. */
    boolean showsOrientation(Draws draws);

    /** One run. */
    Manoeuvre manoeuvre(Draws draws);
}
