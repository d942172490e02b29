package org.auvsim.diagnosis.fit;

/** What is known of parameters beside the runs at hand: that they are normally distributed. */
public final class Knowledge {
    /** Nothing. */
    public static final Knowledge NONE = new Knowledge(new double[0], new double[0][]);

    private final double[] mean;
    private final double[][] information;

    /** Most likely numbers, and the inverse of their covariance. */
    Knowledge(double[] mean, double[][] information) {
        this.mean = mean;
        this.information = information;
    }

    /** That one of some numbers is what it is, but for a deviation. */
    public static Knowledge of(double[] numbers, int one, double deviation) {
        double[][] information = new double[numbers.length][numbers.length];
        information[one][one] = 1 / (deviation * deviation);
        return new Knowledge(numbers, information);
    }

    /** Adds its squared misses to products of columns and misses. */
    void addTo(double[][] products, double[] theta) {
        int n = mean.length;
        int misses = products.length - 1;
        for (int a = 0; a < n; a++) {
            double pull = 0;
            for (int b = 0; b < n; b++) {
                products[a][b] += information[a][b];
                pull += information[a][b] * (theta[b] - mean[b]);
            }
            products[a][misses] += pull;
            products[misses][a] += pull;
        }
        products[misses][misses] += cost(theta);
    }

    /** Squared distance of parameters from the mean, in standard deviations. */
    double cost(double[] theta) {
        double cost = 0;
        for (int a = 0; a < mean.length; a++) {
            for (int b = 0; b < mean.length; b++) {
                cost += (theta[a] - mean[a]) * information[a][b] * (theta[b] - mean[b]);
            }
        }
        return cost;
    }
}
