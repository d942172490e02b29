package org.auvsim.diagnosis.cause;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Load;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Now;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Push;

import java.util.List;
import java.util.function.Function;
import java.util.stream.DoubleStream;

/**
 * A cause beside its equation, both about the body of the {@link Tank}.
 *
 * @param subject what it is about; empty: nothing in particular
 * @param believed elements of the model's body
 * @param theta numbers of the cause
 * @param areTold whether they are as people are told them, each of its own parameter alone
 * @param equations of the model and the cause together
 * @param error by which the two motions may differ
 */
record CauseCase(
        String id,
        String subject,
        String believed,
        List<Double> theta,
        boolean areTold,
        RigidBodyEquations equations,
        double error) {
    static final double MASS = 12;
    static final double G = 9.80665;
    static final Vector3D INERTIA = new Vector3D(0.5, 0.9, 1.1);
    static final Push NOTHING = now -> Load.force(Vector3D.ZERO);

    /** What is smooth may differ so much. */
    static final double SMOOTH = 2e-5;

    /** What jumps is spread a little. */
    private static final double JUMPING = 1e-3;

    static CauseCase cause(String id, String believed, Push push, double... theta) {
        RigidBodyEquations body =
                new RigidBodyEquations(new Vector3D(MASS, MASS, MASS), INERTIA, push);
        return new CauseCase(id, "", believed, numbers(theta), false, body, SMOOTH);
    }

    /** The same about something. */
    static CauseCase about(String subject, CauseCase of) {
        return new CauseCase(
                of.id, subject, of.believed, of.theta, of.areTold, of.equations, of.error);
    }

    /** The same of what jumps. */
    static CauseCase loosely(CauseCase of) {
        return new CauseCase(
                of.id, of.subject, of.believed, of.theta, of.areTold, of.equations, JUMPING);
    }

    /** The same, its numbers as people are told them. */
    static CauseCase told(CauseCase of) {
        return new CauseCase(
                of.id, of.subject, of.believed, of.theta, true, of.equations, of.error);
    }

    /** Numbers of a cause that are told so: what is told of each grows with it evenly. */
    double[] theta(Cause cause) {
        double[] theta = this.theta.stream().mapToDouble(x -> x).toArray();
        for (int i = 0; areTold && i < theta.length; i++) {
            theta[i] = 0;
            double atZero = cause.quantities(theta).get(i).value();
            theta[i] = 1;
            double atOne = cause.quantities(theta).get(i).value();
            theta[i] = (this.theta.get(i) - atZero) / (atOne - atZero);
        }
        return theta;
    }

    static List<Double> numbers(double... theta) {
        return DoubleStream.of(theta).boxed().toList();
    }

    static Push force(Function<Now, Vector3D> force) {
        return now -> Load.force(force.apply(now));
    }

    static Vector3D drag(double k, Vector3D v) {
        return v.scalarMultiply(-k * v.getNorm());
    }

    @Override
    public String toString() {
        return subject.isEmpty() ? id : id + " (" + subject + ")";
    }
}
