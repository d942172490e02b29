package org.auvsim.junit;

import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectMethod;

import org.junit.platform.engine.DiscoverySelector;
import org.junit.platform.engine.OutputDirectoryCreator;
import org.junit.platform.engine.TestDescriptor;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.testkit.engine.EngineExecutionResults;
import org.junit.platform.testkit.engine.EngineTestKit;
import org.junit.platform.testkit.engine.Event;

import java.nio.file.Path;

/** Tests that are run inside of a test, and what JUnit says of them. */
final class Tested {
    private final EngineExecutionResults results;

    private Tested(DiscoverySelector tests, Path folder) {
        results =
                EngineTestKit.engine("junit-jupiter")
                        .selectors(tests)
                        .outputDirectoryCreator(new InFolder(folder))
                        .execute();
    }

    /** One test of a class; what it publishes goes to a folder. */
    static Tested method(Class<?> tests, String name, Path folder) {
        return new Tested(selectMethod(tests, name, Replay.class), folder);
    }

    /** All tests of a class. */
    static Tested all(Class<?> tests, Path folder) {
        return new Tested(selectClass(tests), folder);
    }

    long succeeded() {
        return results.testEvents().succeeded().count();
    }

    /** What the one test failed with. */
    Throwable failure() {
        return results.testEvents().failed().stream()
                .map(Event::getPayload)
                .map(payload -> (TestExecutionResult) payload.orElseThrow())
                .flatMap(result -> result.getThrowable().stream())
                .findFirst()
                .orElseThrow();
    }

    /** How many files JUnit was told of. */
    long filesPublished() {
        return results.testEvents().fileEntryPublished().count();
    }

    private record InFolder(Path getRootDirectory) implements OutputDirectoryCreator {
        @Override
        public Path createOutputDirectory(TestDescriptor test) {
            return getRootDirectory;
        }
    }
}
