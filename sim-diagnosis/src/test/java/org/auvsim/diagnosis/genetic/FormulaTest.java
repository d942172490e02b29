package org.auvsim.diagnosis.genetic;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.genetic.Expression.Constant;
import org.auvsim.diagnosis.genetic.Expression.Operation;
import org.auvsim.diagnosis.genetic.Expression.Variable;
import org.junit.jupiter.api.Test;

import java.util.List;

class FormulaTest {
    private static Expression variable(String name) {
        return new Variable(Variable.NAMES.indexOf(name));
    }

    private static Expression of(Operator operator, Expression... parts) {
        return new Operation(operator, List.of(parts));
    }

    /** "0.1 + -6 vx -2" might be a difference. */
    @Test
    void aProductIsToldFromADifference() {
        Expression product = of(Operator.TIMES, variable("vx"), new Constant(-2));

        assertThat(new Formula(product, 0.1, -6, 1).text())
                .isEqualTo("0.100 + (-6.00) * vx * (-2.000)");
        assertThat(of(Operator.MINUS, variable("vx"), new Constant(2)).text())
                .isEqualTo("(vx - 2.000)");
    }

    @Test
    void whatIsInsideOthersIsToldFromWhatIsBeside() {
        Expression y = of(Operator.MAGNITUDE, variable("y"));
        Expression sum = of(Operator.PLUS, variable("x"), new Constant(-0.5));

        assertThat(of(Operator.TIMES, of(Operator.SINE, sum), y).text())
                .isEqualTo("sin((x + (-0.5000))) * |y|");
    }
}
