package org.auvsim.auvsml.message;

import org.auvsim.auvsml.mapping.RoundTripContract;

/** Every registered message. */
class RoundTripTest extends RoundTripContract {}
