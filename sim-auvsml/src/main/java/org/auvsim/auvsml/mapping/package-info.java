/**
 * Records to XML and back, from the records' own component names and types.
 *
 * <p>The rules: an element has its record's name in kebab-case; scalars are attributes, records are
 * elements named after their component, lists repeat that element, and a component that is an
 * interface is an element named after the record that implements it.
 */
@NullMarked
package org.auvsim.auvsml.mapping;

import org.jspecify.annotations.NullMarked;
