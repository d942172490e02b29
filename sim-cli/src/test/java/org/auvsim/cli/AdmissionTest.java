package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.Role;
import org.auvsim.cli.report.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import picocli.CommandLine;

class AdmissionTest {
    private static Admission admission(String... options) {
        Admission admission = new Admission();
        new CommandLine(admission).setCaseInsensitiveEnumValuesAllowed(true).parseArgs(options);
        return admission;
    }

    @ParameterizedTest
    @ValueSource(strings = {"127.0.0.1", "localhost", "127.0.0.9", "::1"})
    void whoIsOnThisMachineMayDoEverything(String address) {
        assertThat(admission("--bind", address).role()).isEqualTo(Role.ADMIN);
    }

    @ParameterizedTest
    @CsvSource({"viewer, VIEWER", "controller, CONTROLLER", "admin, ADMIN"})
    void whatOthersMayDoIsStated(String name, Role role) {
        assertThat(admission("--bind", "0.0.0.0", "--role", name).role()).isEqualTo(role);
        assertThat(admission("--role", name).role()).isEqualTo(role);
    }

    @Test
    void whatOthersMayDoMustBeStated() {
        assertThatThrownBy(admission("--bind", "0.0.0.0")::role)
                .isInstanceOf(UserError.class)
                .hasMessageContaining("--role viewer, controller or admin");
    }
}
