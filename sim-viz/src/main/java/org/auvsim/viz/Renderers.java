package org.auvsim.viz;

import org.auvsim.viz.drawing.Renderer;
import org.auvsim.viz.drawing.ScreenException;

import java.util.List;
import java.util.ServiceLoader;

/** The renderers that there are: the viewer's own and those of extensions. */
public final class Renderers {
    private Renderers() {}

    /**
     * The renderer of a name.
     *
     * @param loader sees the provider files of all that are there
     * @throws ScreenException if there is none; its sentence tells which there are
     */
    public static Renderer named(String name, ClassLoader loader) throws ScreenException {
        List<Renderer> all =
                ServiceLoader.load(Renderer.class, loader).stream()
                        .map(ServiceLoader.Provider::get)
                        .toList();
        return all.stream()
                .filter(renderer -> renderer.name().equals(name))
                .findFirst()
                .orElseThrow(() -> unknown(name, all));
    }

    private static ScreenException unknown(String name, List<Renderer> all) {
        return new ScreenException(
                ("There is no renderer '%s'; there %s. One of an extension is found in"
                     + " ~/.auvsim/extensions or --extensions DIR (docs/osp.md has the one for Open"
                     + " Source Physics).")
                        .formatted(
                                name,
                                all.size() == 1
                                        ? "is " + all.getFirst().name()
                                        : "are "
                                                + String.join(
                                                        ", ",
                                                        all.stream()
                                                                .map(Renderer::name)
                                                                .sorted()
                                                                .toList())));
    }
}
