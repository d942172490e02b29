package org.auvsim.checks.offender.server.b;

import org.auvsim.checks.offender.server.a.UsesB;

import java.util.List;

public record UsesA(List<UsesB> back) {
    static UsesA first(UsesB back) {
        return new UsesA(List.of(back));
    }
}
