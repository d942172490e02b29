package org.auvsim.viz.window;

import org.auvsim.core.description.ElementName;
import org.auvsim.core.entity.Component;
import org.auvsim.viz.scene.SeenObject;

import java.util.List;

/** A row of the tree of objects. */
sealed interface Row {
    /** What it is called. */
    String name();

    /** What it is, for whoever points at it. */
    default String words() {
        return name();
    }

    /** Whether there is something below it. */
    boolean isBranch();

    /** How far it is indented. */
    int depth();

    /** The same for a row and for what it has become when objects are read again. */
    Object key();

    /** All objects of a kind. */
    record Group(Kind kind, int count) implements Row {
        @Override
        public String name() {
            return "%s (%d)".formatted(kind.title(), count);
        }

        @Override
        public boolean isBranch() {
            return true;
        }

        @Override
        public int depth() {
            return 0;
        }

        @Override
        public Object key() {
            return kind;
        }
    }

    /** An object. */
    record Item(SeenObject object) implements Row {
        @Override
        public String name() {
            return object.name();
        }

        @Override
        public boolean isBranch() {
            return object.definition().filter(d -> !d.component().isEmpty()).isPresent();
        }

        @Override
        public int depth() {
            return 1;
        }

        @Override
        public Object key() {
            return object.id();
        }
    }

    /** A propulsor, a fin, a sensor or another component of an object. */
    record Part(SeenObject owner, Component component) implements Row {
        @Override
        public String name() {
            return component.name();
        }

        @Override
        public String words() {
            return component.name() + ", " + ElementName.of(component.getClass());
        }

        @Override
        public boolean isBranch() {
            return false;
        }

        @Override
        public int depth() {
            return 2;
        }

        @Override
        public Object key() {
            return List.of(owner.id(), words());
        }
    }
}
