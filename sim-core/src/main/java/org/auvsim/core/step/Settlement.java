package org.auvsim.core.step;

import org.auvsim.core.contact.ContactSolver;

/**
 * Brings an island of bodies in contact over one segment of time. First impulses end what
 * approaches too fast to stay apart; then constant forces are sought under which all contacts stay
 * open:
 *
 * <ol>
 *   <li>The bodies are traced to the segment's end with the forces that their contacts had last
 *       time ({@link RememberedForces}): a trial ({@link IslandTrial}).
 *   <li>The contacts are looked up where the trial has the bodies halfway ({@link IslandContacts}).
 *       So the forces' work is right to the third order of the time (the midpoint rule: Hairer,
 *       Lubich &amp; Wanner, Geometric Numerical Integration, VI.4) and what turns gains no energy.
 *   <li>Each contact gets the speed that it is to have at the end, from the gap and the speed with
 *       which the trial ends ({@link GapForecast}, {@link ContactAims}), and the slip that only
 *       seems to be one is excused ({@link TurningSlip}).
 *   <li>The forces are solved for which lead there, and the bodies are traced with these; and so on
 *       until a trial ends as it was solved for.
 * </ol>
 *
 * <p>Where the contacts still do more work than it takes to open gaps, or a body's forces turn out
 * to be stiff, the segment ends earlier. What is at rest stays where it is to within micrometres
 * (ten boxes on each other: 1e-6 m in 15 s).
 */
final class Settlement {
    /** How well what approaches is stopped (m/s): the forces mend the rest. */
    private static final double STOP_TOLERANCE = 1e-6;

    /** How well the forces are solved for (m/s): stacks amplify errors. */
    private static final double TOLERANCE = 1e-6;

    /**
     * The same within a frame, where errors do not add up from frame to frame, and for balls
     * without friction, which only have to stay apart.
     */
    private static final double ROUGH = 1e-5;

    /** How well a trial has to end as solved for, as a share of the fastest speed. */
    private static final double SHARE_OF_SPEED = 0.01;

    private static final int MOST_SWEEPS = 400;

    /**
     * What rests settles in two or three; bodies that the water holds back in a frame come nearer
     * to what was solved for by only a third of the rest in each.
     */
    private static final int MOST_ROUNDS = 50;

    /** Contacts may do this share of the bodies' energy as work in a segment: rounding and more. */
    private static final double WORK_TOLERANCE = 1e-7;

    /** No frame is cut into more segments than this to keep contacts from doing work. */
    private static final int MOST_PARTS = 64;

    private final Trajectories trajectories;
    private final ContactProblem problem;
    private final IslandTrial trial;
    private final IslandContacts contacts;
    private final GapForecast gaps;
    private final ContactAims aims;
    private final TurningSlip slip;
    private final RememberedForces remembered;
    private final StepTally tally;
    private final ContactSolver stopping = ContactSolver.forResting(STOP_TOLERANCE, MOST_SWEEPS);
    private final ContactSolver accurate = ContactSolver.forResting(TOLERANCE, MOST_SWEEPS);
    private final ContactSolver rough = ContactSolver.forResting(ROUGH, MOST_SWEEPS);

    /** Whether the contact forces were found to within the solver's tolerance when last asked. */
    private boolean isSolved;

    Settlement(
            Motion motion,
            BodyTraits traits,
            Trajectories trajectories,
            Touch touch,
            ContactProblem problem,
            RestingContacts resting) {
        this.trajectories = trajectories;
        tally = motion.tally();
        this.problem = problem;
        Paths paths = trajectories.paths();
        ContactPlace place = new ContactPlace(motion.bodies(), problem);
        trial = new IslandTrial(motion.bodies(), traits, trajectories, problem, resting.pairs());
        contacts = new IslandContacts(traits, paths, touch, problem, resting);
        gaps = new GapForecast(paths, touch, problem, trial, contacts);
        aims = new ContactAims(problem, contacts, gaps);
        slip = new TurningSlip(problem, trial, contacts, place);
        remembered = new RememberedForces(motion.memory(), problem, contacts, place);
    }

    /**
     * Gives the island's bodies, which have been found in {@link RestingContacts#pairs}, new
     * segments from an offset on, on which they stay in contact.
     *
     * @param length of the frame (s)
     * @param time of the world (s) at the offset
     */
    void settle(double offset, double length, double time) {
        isSolved = true;
        begin(offset, length);
        remembered.find(time);
        setRemembered(length - offset);
        double end = trial.trace(offset, length);
        boolean isSettled = contacts.count() == 0;
        while (!isSettled) {
            double reached = hold(offset, end, length);
            isSettled = reached == end;
            end = isSettled ? end : trial.trace(offset, reached);
        }
        tally.unsolvedIslands += isSolved ? 0 : 1;
    }

    /** Finds the contacts where the segment starts, and stops what would meet before its end. */
    private void begin(double offset, double length) {
        trial.begin(offset);
        contacts.findAtStart();
        if (aims.aimAtStop(length - offset)) {
            stopping.solve(problem.bodies, problem.contacts);
            trial.applyImpulses();
        }
        if (turns()) {
            gaps.noteStart();
            slip.noteStart();
        }
    }

    private boolean turns() {
        return trajectories.paths().turn();
    }

    /** Starts with the forces that the contacts had last time. */
    private void setRemembered(double h) {
        remembered.guess(h);
        accurate.sum(problem.bodies, problem.contacts);
        trial.setForces(h);
    }

    /**
     * Finds the contact forces under which the island stays apart up to {@code end}.
     *
     * @return that offset, or the earlier one at which the segment has to end
     */
    private double hold(double offset, double end, double length) {
        double h = end - offset;
        double near = near(h);
        double change = Double.POSITIVE_INFINITY;
        for (int round = 0; change > near && round < MOST_ROUNDS; round++) {
            pose(h);
            change = solve(h, offset > 0);
            trial.setForces(h);
            double reached = trial.trace(offset, end);
            if (reached < end) {
                return reached;
            }
        }
        boolean isLong = h * MOST_PARTS > length;
        return isLong && turns() && gainsEnergy(h) ? offset + h / 2 : end;
    }

    /**
     * How well (m/s, rad/s) a trial has to end as solved for: so that gaps stay open, and better
     * the slower the bodies are.
     */
    private double near(double h) {
        double open = aims.leastGap() / h;
        return Math.min(open, Math.max(TOLERANCE, SHARE_OF_SPEED * trial.fastest()));
    }

    /** Poses the problem: the contacts halfway through the trial, and what is to be reached. */
    private void pose(double h) {
        trial.placeHalfway();
        contacts.findHalfway();
        if (turns()) {
            slip.excuse();
        }
        gaps.foretell(h);
        aims.aimAtEnd(h);
        remembered.guess(h);
        trial.useUnforcedVelocity(h);
    }

    /**
     * Solves for the contact forces over {@code h} (s).
     *
     * @return by how much (m/s, rad/s) the bodies are to end differently from the trial
     */
    private double solve(double h, boolean isWithinFrame) {
        boolean mayBeRough = isWithinFrame || problem.contacts.areCentral();
        ContactSolver solver = mayBeRough ? rough : accurate;
        isSolved = solver.solve(problem.bodies, problem.contacts).converged();
        remembered.remember(h);
        return trial.difference();
    }

    /** Whether the trial's contact forces give energy beyond what it takes to open gaps. */
    private boolean gainsEnergy(double h) {
        return trial.work(h) > WORK_TOLERANCE * trial.energy(h) + gaps.workOfOpening(h);
    }
}
