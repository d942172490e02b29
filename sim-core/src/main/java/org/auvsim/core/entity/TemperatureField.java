package org.auvsim.core.entity;

/** A field of water temperature (degrees Celsius); those of a world add up. */
public interface TemperatureField extends Field<Double> {}
