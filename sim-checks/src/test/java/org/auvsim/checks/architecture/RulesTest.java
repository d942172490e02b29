package org.auvsim.checks.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;

import org.junit.jupiter.api.Test;

import java.util.List;

/** Each rule finds what breaks it. */
class RulesTest {
    private static final String BASE = "org.auvsim.checks.offender";
    private static final JavaClasses OFFENDERS = new ClassFileImporter().importPackages(BASE);

    private final Rules rules = new Rules(BASE);

    @Test
    void aLowerModuleUsesAHigherOne() {
        assertThat(offences(rules.modulesUseThoseBeforeThem()))
                .isNotEmpty()
                .allMatch(text -> text.contains("core.volume.UsesServer"));
    }

    @Test
    void aLowerPackageUsesAHigherOneAndAnotherHasNoPlace() {
        List<String> offences = offences(rules.packagesOfCoreUseThoseBeforeThem());
        assertThat(offences)
                .anyMatch(text -> text.contains("core.math.UsesVolume"))
                .anyMatch(text -> text.contains("HasNoPlace has no place in the order"))
                .allMatch(text -> text.contains("UsesVolume") || text.contains("HasNoPlace"));
    }

    @Test
    void twoPackagesUseEachOther() {
        assertThat(offences(rules.packagesHaveNoCycles()))
                .singleElement()
                .asString()
                .contains("Slice server.a", "Slice server.b");
    }

    @Test
    void aHiddenEffectIsMadeOfTheSimulatorsPhysics() {
        assertThat(offences(rules.hiddenEffectsHaveTheirOwnPhysics()))
                .isNotEmpty()
                .allMatch(text -> text.contains("Borrows"));
    }

    @Test
    void theServerPrints() {
        assertThat(offences(rules.onlyTheCommandLinePrints()))
                .anyMatch(text -> text.contains("Talks.toTheConsole()"))
                .anyMatch(text -> text.contains("Talks.toTheErrorStream("))
                .anyMatch(text -> text.contains("Talks.toTheLogOfTheJdk()"))
                .allMatch(text -> text.contains("Talks."));
    }

    @Test
    void coreCallsTheInexactSine() {
        assertThat(offences(rules.coreIsExact()))
                .singleElement()
                .asString()
                .contains("Varies.sine(");
    }

    @Test
    void coreReadsTheClock() {
        assertThat(offences(rules.coreHasNoClock()))
                .hasSize(2)
                .allMatch(text -> text.contains("Varies.time()"));
    }

    @Test
    void coreReachesOutside() {
        assertThat(offences(rules.coreHasNoFilesNetworkTimeThreadsOrLog()))
                .anyMatch(text -> text.contains("Varies.chance()"))
                .anyMatch(text -> text.contains("Varies.thread()"))
                .anyMatch(text -> text.contains("Varies.file()"))
                .noneMatch(text -> text.contains("Varies.sine("));
    }

    @Test
    void someoneParsesWithSax() {
        assertThat(offences(rules.nobodyParsesWithSax()))
                .isNotEmpty()
                .allMatch(text -> text.contains("ParsesWithSax"));
    }

    @Test
    void aTestSleeps() {
        assertThat(offences(rules.testsDoNotSleep()))
                .singleElement()
                .asString()
                .contains("Sleeps.aWhile()");
    }

    private static List<String> offences(ArchRule rule) {
        return rule.evaluate(OFFENDERS).getFailureReport().getDetails();
    }
}
