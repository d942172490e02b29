package org.auvsim.core.step;

import org.junit.jupiter.api.Nested;

/** Each stage that sim-core ships keeps its contract. */
class StageContractsTest {
    @Nested
    class OfRadiusDistanceRestricter extends RestricterContract {
        @Override
        protected TimeStepRestricter restricter() {
            return new RadiusDistanceRestricter();
        }
    }

    @Nested
    class OfMaximumSpeedRestricter extends RestricterContract {
        @Override
        protected TimeStepRestricter restricter() {
            return new MaximumSpeedRestricter(10);
        }
    }

    @Nested
    class OfNoRestricter extends RestricterContract {
        @Override
        protected TimeStepRestricter restricter() {
            return new NoRestricter();
        }
    }

    @Nested
    class OfOctreePartitioner extends PartitionerContract {
        @Override
        protected CollisionPartitioner partitioner() {
            return OctreePartitioner.standard();
        }
    }

    @Nested
    class OfDeepOctreePartitioner extends PartitionerContract {
        @Override
        protected CollisionPartitioner partitioner() {
            return new OctreePartitioner(8, 1);
        }
    }

    @Nested
    class OfAllPairsPartitioner extends PartitionerContract {
        @Override
        protected CollisionPartitioner partitioner() {
            return new AllPairsPartitioner();
        }
    }

    @Nested
    class OfBisectionFinder extends FinderContract {
        @Override
        protected CollisionFinder finder() {
            return BisectionFinder.standard();
        }
    }

    @Nested
    class OfEndOfStepFinder extends FinderContract {
        @Override
        protected CollisionFinder finder() {
            return new EndOfStepFinder();
        }
    }

    @Nested
    class OfAnalyticFinder extends FinderContract {
        @Override
        protected CollisionFinder finder() {
            return new AnalyticFinder();
        }
    }

    @Nested
    class OfSnapshotStepper extends StepperContract {
        @Override
        protected Stepper stepper() {
            return SnapshotStepper.standard();
        }
    }

    @Nested
    class OfSnapshotStepperWithAlternativeStages extends StepperContract {
        @Override
        protected Stepper stepper() {
            return new SnapshotStepper(
                    new MaximumSpeedRestricter(10),
                    new AllPairsPartitioner(),
                    new BisectionFinder(20, 40));
        }
    }

    @Nested
    class OfSnapshotStepperAgainstExactSolutions extends StepperAccuracyContract {
        @Override
        protected Stepper stepper() {
            return SnapshotStepper.standard();
        }
    }

    @Nested
    class OfEventStepper extends StepperContract {
        @Override
        protected Stepper stepper() {
            return EventStepper.standard();
        }
    }

    @Nested
    class OfEventStepperAgainstExactSolutions extends StepperAccuracyContract {
        @Override
        protected Stepper stepper() {
            return EventStepper.standard();
        }
    }
}
