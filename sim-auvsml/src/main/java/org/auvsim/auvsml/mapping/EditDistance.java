package org.auvsim.auvsml.mapping;

/**
 * How far what was typed is from what is known, by the slips of typing (Damerau 1964): two letters
 * that changed places are one slip, and are not changed again.
 */
public final class EditDistance {
    private EditDistance() {}

    /**
     * The least number of letters to put in, take out or replace, and of neighbours to exchange,
     * that makes one the other.
     */
    public static int between(String one, String other) {
        int[][] of = new int[one.length() + 1][other.length() + 1];
        for (int i = 0; i <= one.length(); i++) {
            for (int j = 0; j <= other.length(); j++) {
                of[i][j] = i == 0 || j == 0 ? i + j : least(of, one, i, other, j);
            }
        }
        return of[one.length()][other.length()];
    }

    /** From the beginnings that are a letter shorter, or two. */
    private static int least(int[][] of, String one, int i, String other, int j) {
        boolean isSame = one.charAt(i - 1) == other.charAt(j - 1);
        int replaced = of[i - 1][j - 1] + (isSame ? 0 : 1);
        int least = Math.min(replaced, 1 + Math.min(of[i - 1][j], of[i][j - 1]));
        boolean isExchanged =
                i > 1
                        && j > 1
                        && one.charAt(i - 1) == other.charAt(j - 2)
                        && one.charAt(i - 2) == other.charAt(j - 1);
        return isExchanged ? Math.min(least, 1 + of[i - 2][j - 2]) : least;
    }
}
