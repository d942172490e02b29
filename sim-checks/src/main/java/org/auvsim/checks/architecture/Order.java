package org.auvsim.checks.architecture;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;

import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * The parts of a package in the order of their dependencies: each may use itself and those of the
 * levels before its own. A part that has no place in the order breaks the rule, too.
 */
record Order(String root, List<Set<String>> levels) {
    ArchRule rule() {
        return classes()
                .that()
                .resideInAPackage(root + "..")
                .and()
                .resideOutsideOfPackages(root, root + ".checks..")
                .should(useOnlyWhatIsBefore());
    }

    private ArchCondition<JavaClass> useOnlyWhatIsBefore() {
        return new ArchCondition<>("use only themselves and what is before them in " + levels) {
            @Override
            public void check(JavaClass user, ConditionEvents events) {
                if (level(user).isEmpty()) {
                    String place = user.getName() + " has no place in the order " + levels;
                    events.add(SimpleConditionEvent.violated(user, place));
                }
                user.getDirectDependenciesFromSelf().stream()
                        .filter(use -> !isAllowed(use))
                        .map(use -> SimpleConditionEvent.violated(use, use.getDescription()))
                        .forEach(events::add);
            }
        };
    }

    private boolean isAllowed(Dependency use) {
        OptionalInt from = level(use.getOriginClass());
        OptionalInt to = level(use.getTargetClass());
        return from.isEmpty()
                || to.isEmpty()
                || to.getAsInt() < from.getAsInt()
                || part(use.getOriginClass()).equals(part(use.getTargetClass()));
    }

    private OptionalInt level(JavaClass type) {
        String part = part(type);
        return IntStream.range(0, levels.size())
                .filter(i -> levels.get(i).contains(part))
                .findFirst();
    }

    /** The name after the root's in the class' package; empty outside of the root. */
    private String part(JavaClass type) {
        String prefix = root + ".";
        String name = type.getPackageName();
        return name.startsWith(prefix) ? name.substring(prefix.length()).split("\\.", 2)[0] : "";
    }
}
