package org.auvsim.checks.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.GeneralCodingRules.ACCESS_STANDARD_STREAMS;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.lang.ArchRule;

import java.util.List;
import java.util.Set;

/** The rules of the architecture, for the packages below a base package. */
final class Rules {
    /** What {@link StrictMath} gives to the last bit, and {@link Math} only nearly. */
    private static final Set<String> INEXACT =
            Set.of(
                    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh",
                    "exp", "expm1", "log", "log10", "log1p", "pow", "cbrt", "hypot", "random");

    /** In which measured runs are handed over. */
    private static final Set<String> HANDED_OVER = Set.of("Vec3", "Quat", "NamedForce", "Frame");

    private final String base;

    Rules(String base) {
        this.base = base;
    }

    ArchRule modulesUseThoseBeforeThem() {
        return new Order(
                        base,
                        List.of(
                                Set.of("core"),
                                Set.of("auvsml", "plot"),
                                Set.of("server", "viz"),
                                Set.of("diagnosis", "junit"),
                                Set.of("experiments"),
                                Set.of("cli", "examples", "bench", "osp")))
                .rule();
    }

    ArchRule packagesOfCoreUseThoseBeforeThem() {
        return new Order(
                        base + ".core",
                        List.of(
                                Set.of("description"),
                                Set.of("math"),
                                Set.of("contact", "volume"),
                                Set.of("entity"),
                                Set.of("actuator"),
                                Set.of("field", "effect", "behavior", "dynamics", "sensor"),
                                Set.of("step", "communication"),
                                Set.of("world")))
                .rule();
    }

    ArchRule packagesHaveNoCycles() {
        return slices().matching(base + ".(**)").should().beFreeOfCycles();
    }

    ArchRule onlyTheCommandLinePrints() {
        return noClasses()
                .that()
                .resideOutsideOfPackages(base + ".cli..", base + ".examples..")
                .should(ACCESS_STANDARD_STREAMS)
                .orShould()
                .dependOnClassesThat()
                .resideInAPackage("java.util.logging..")
                .orShould()
                .callMethodWhere(named(Throwable.class, Set.of("printStackTrace")));
    }

    ArchRule coreIsExact() {
        return noClasses()
                .that()
                .resideInAPackage(base + ".core..")
                .should()
                .callMethodWhere(named(Math.class, INEXACT));
    }

    ArchRule coreHasNoClock() {
        return noClasses()
                .that()
                .resideInAPackage(base + ".core..")
                .should()
                .callMethodWhere(named(System.class, Set.of("nanoTime", "currentTimeMillis")));
    }

    ArchRule coreHasNoFilesNetworkTimeThreadsOrLog() {
        return noClasses()
                .that()
                .resideInAPackage(base + ".core..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "java.io..",
                        "java.net..",
                        "java.nio..",
                        "java.time..",
                        "java.util.concurrent..",
                        "java.util.random..",
                        "java.util.logging..",
                        "org.slf4j..")
                .orShould()
                .dependOnClassesThat()
                .haveNameMatching(
                        "java\\.lang\\.(Thread|Runtime|Process.*)|java\\.util\\.(Random|Timer)");
    }

    /** What judges the simulator must not be made of it. */
    ArchRule hiddenEffectsHaveTheirOwnPhysics() {
        return noClasses()
                .that()
                .resideInAPackage(base + ".experiments.hidden..")
                .should()
                .dependOnClassesThat(
                        describe(
                                "are the simulator's, but for what runs are handed over in",
                                of ->
                                        of.getPackageName().startsWith(base + ".core")
                                                && !HANDED_OVER.contains(of.getSimpleName())));
    }

    /** What one JDOM2 SAXBuilder sets reaches the others: a hardened one can read files again. */
    ArchRule nobodyParsesWithSax() {
        return noClasses()
                .should()
                .dependOnClassesThat()
                .haveFullyQualifiedName("org.jdom2.input.SAXBuilder");
    }

    ArchRule testsDoNotSleep() {
        return noClasses()
                .should()
                .callMethodWhere(named(Thread.class, Set.of("sleep")))
                .as("tests wait for what they wait for, never for a time");
    }

    private static DescribedPredicate<JavaMethodCall> named(Class<?> owner, Set<String> methods) {
        return describe(
                owner.getSimpleName() + "." + methods,
                call ->
                        methods.contains(call.getName())
                                && call.getTargetOwner().isAssignableTo(owner));
    }
}
