// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

/** Light from above, a little from everywhere, and a little from the camera. */
final class Light {
    private static final double[] SUN = {0.3509, -0.2506, 0.9023};

    /** So many shades of a colour are told apart; faces of one shade are painted as one element. */
    private static final int SHADES = 24;

    private Light() {}

    /** What a colour looks like on a face that looks along a normal. */
    static int on(int colour, Plane face, View view) {
        double side = view.isBefore(face) ? 1 : -1;
        double up = side * face.nz();
        double sun = side * (face.nx() * SUN[0] + face.ny() * SUN[1] + face.nz() * SUN[2]);
        double camera =
                Math.abs(
                        face.nx() * view.forward(0)
                                + face.ny() * view.forward(1)
                                + face.nz() * view.forward(2));
        double light = 0.42 + 0.08 * up + 0.38 * Math.max(sun, 0) + 0.18 * camera;
        return shade(colour, Math.rint(light * SHADES) / SHADES);
    }

    private static int shade(int colour, double light) {
        int shaded = colour & 0xff000000;
        for (int shift = 0; shift <= 16; shift += 8) {
            long part = Math.round((colour >> shift & 0xff) * light);
            shaded |= (int) Math.clamp(part, 0L, 255L) << shift;
        }
        return shaded;
    }
}
