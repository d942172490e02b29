package org.auvsim.examples.scala

import org.auvsim.core.math.Vec3

/** The vectors of auvsim with operators. */
extension (a: Vec3)
  def +(b: Vec3): Vec3 = a.plus(b)
  def -(b: Vec3): Vec3 = a.minus(b)
  def *(factor: Double): Vec3 = a.times(factor)

/** The physics of a bungee: a spring and a dashpot side by side. */
object BungeeForce:
  /**
   * The force (N, world) on a body at `position` (m) that moves with `velocity` (m/s).
   *
   * @param stiffness N/m
   * @param damping N s/m
   */
  def on(anchor: Vec3, stiffness: Double, damping: Double, position: Vec3, velocity: Vec3): Vec3 =
    (anchor - position) * stiffness - velocity * damping
