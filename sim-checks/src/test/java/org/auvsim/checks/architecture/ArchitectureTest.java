package org.auvsim.checks.architecture;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;

import org.junit.jupiter.api.Test;

/** The rules hold for what is here. */
class ArchitectureTest {
    private static final JavaClasses MAIN = Compiled.main();
    private static final JavaClasses TESTS =
            Compiled.tests()
                    .that(
                            DescribedPredicate.not(
                                    JavaClass.Predicates.resideInAPackage(
                                            "org.auvsim.checks.offender..")));

    private final Rules rules = new Rules("org.auvsim");

    @Test
    void modulesUseThoseBeforeThem() {
        rules.modulesUseThoseBeforeThem().check(MAIN);
    }

    @Test
    void packagesOfCoreUseThoseBeforeThem() {
        rules.packagesOfCoreUseThoseBeforeThem().check(MAIN);
    }

    @Test
    void packagesHaveNoCycles() {
        rules.packagesHaveNoCycles().check(MAIN);
    }

    @Test
    void onlyTheCommandLinePrints() {
        rules.onlyTheCommandLinePrints().check(MAIN);
    }

    @Test
    void coreIsExact() {
        rules.coreIsExact().check(MAIN);
    }

    @Test
    void coreHasNoClock() {
        rules.coreHasNoClock().check(MAIN);
    }

    @Test
    void coreHasNoFilesNetworkTimeThreadsOrLog() {
        rules.coreHasNoFilesNetworkTimeThreadsOrLog().check(MAIN);
    }

    @Test
    void hiddenEffectsHaveTheirOwnPhysics() {
        rules.hiddenEffectsHaveTheirOwnPhysics().check(MAIN);
    }

    @Test
    void nobodyParsesWithSax() {
        rules.nobodyParsesWithSax().check(MAIN);
        rules.nobodyParsesWithSax().check(TESTS);
    }

    @Test
    void testsDoNotSleep() {
        rules.testsDoNotSleep().check(TESTS);
    }
}
