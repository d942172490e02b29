package org.auvsim.core.dynamics;

class Rk4Test extends IntegratorContract {
    @Override
    protected Integrator integrator() {
        return new Rk4();
    }

    @Override
    protected int order() {
        return 4;
    }
}
