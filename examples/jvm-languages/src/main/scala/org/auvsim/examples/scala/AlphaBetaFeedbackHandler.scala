package org.auvsim.examples.scala

import org.auvsim.core.math.Vec3
import org.auvsim.server.feedback.{Correction, FeedbackProcessor}
import org.auvsim.server.feedback.FeedbackProcessor.Phase

/**
 * An alpha-beta filter: of how far the measured place is from the projected one, the object takes
 * the share alpha, and its velocity the share beta in the time since the last measurement (Benedict
 * & Bordner, Synthesis of an optimal set of radar track-while-scan smoothing equations, 1962).
 * What else was measured is taken as it is.
 */
final class AlphaBetaFeedbackHandler extends FeedbackProcessor:
  import AlphaBetaFeedbackHandler.*

  override def phase: Phase = Phase.AFTER_STEP

  override def process(correction: Correction): Unit =
    val body = correction.`object`
    val target = correction.target
    target.orientation.ifPresent(body.setOrientation(_))
    target.angularVelocity.ifPresent(body.setAngularVelocity(_))
    target.position.ifPresent: measured =>
      val residual = measured - body.position
      body.setPosition(body.position + residual * Alpha)
      body.setVelocity(body.velocity + residual * (Beta / interval(correction)))
    target.velocity.ifPresent(body.setVelocity(_))
    correction.remember(Measured(correction.time))

  /** How long (s) ago the last measurement was; of the first, how long the step is. */
  private def interval(correction: Correction): Double =
    val last = correction.memory(classOf[Measured]).map(_.time)
    math.max(correction.time - last.orElse(Double.NegativeInfinity), correction.duration) match
      case Double.PositiveInfinity => correction.duration
      case seconds => seconds

object AlphaBetaFeedbackHandler:
  /** The share of the residual that the place takes. */
  val Alpha = 0.5

  /** The share that the velocity takes: the best for this alpha, of an object that accelerates by chance. */
  val Beta: Double = Alpha * Alpha / (2 - Alpha)

  /** When the last measurement was (s). */
  private final case class Measured(time: Double)
