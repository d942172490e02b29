package org.auvsim.core.volume;

final class BoxBox implements PairQuery<Box, Box> {
    @Override
    public boolean overlap(Box a, Pose poseA, Box b, Pose poseB) {
        throw new UnsupportedOperationException();
    }

    @Override
    public ContactPoint contact(Box a, Pose poseA, Box b, Pose poseB) {
        throw new UnsupportedOperationException();
    }
}
