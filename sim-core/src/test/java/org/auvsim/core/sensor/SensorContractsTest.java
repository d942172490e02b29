package org.auvsim.core.sensor;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Nested;

/** All sensors keep the contract. */
class SensorContractsTest {
    private static final ScalarErrors NUMBER = new ScalarErrors(0.1, 0.02, 0.05);
    private static final VectorErrors VECTOR =
            new VectorErrors(new Vec3(0.1, 0.2, 0.3), Vec3.ZERO, new Vec3(0.01, 0, 0.02));
    private static final InertialErrors INERTIAL =
            new InertialErrors(new Vec3(0.1, 0.2, 0.3), Vec3.ZERO, new Vec3(0.01, 0, 0.02));
    private static final Vec3 PLACE = new Vec3(0.1, 0.2, 0.3);
    private static final Quat AXES = Bench.yaw(0.3);

    @Nested
    class OfDepthSensors extends SensorContract {
        @Override
        protected Sensor sensor(Sampling sampling) {
            return new DepthSensor("s", PLACE, 3, 1025, 1020, NUMBER, sampling);
        }
    }

    @Nested
    class OfImus extends SensorContract {
        @Override
        protected Sensor sensor(Sampling sampling) {
            return new Imu("s", PLACE, AXES, 9.81, INERTIAL, INERTIAL, sampling);
        }
    }

    @Nested
    class OfDopplerLogs extends SensorContract {
        @Override
        protected Sensor sensor(Sampling sampling) {
            return new Dvl("s", PLACE, AXES, 0.5, 30, 1.01, VECTOR, NUMBER, sampling);
        }
    }

    @Nested
    class OfCompasses extends SensorContract {
        @Override
        protected Sensor sensor(Sampling sampling) {
            return new Compass("s", AXES, 0.2, NUMBER, sampling);
        }
    }

    @Nested
    class OfMagnetometers extends SensorContract {
        @Override
        protected Sensor sensor(Sampling sampling) {
            return new Magnetometer("s", PLACE, AXES, VECTOR, sampling);
        }
    }

    @Nested
    class OfGps extends SensorContract {
        @Override
        protected Sensor sensor(Sampling sampling) {
            return new Gps("s", PLACE, 0, 2, VECTOR, sampling);
        }
    }

    @Nested
    class OfRangeSonars extends SensorContract {
        @Override
        protected Sensor sensor(Sampling sampling) {
            return new RangeSonar("s", PLACE, AXES, 7, 2, 0, 50, NUMBER, sampling);
        }
    }

    @Nested
    class OfThermometers extends SensorContract {
        @Override
        protected Sensor sensor(Sampling sampling) {
            return new Thermometer("s", PLACE, NUMBER, sampling);
        }
    }
}
