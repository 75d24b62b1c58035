/* Every number of the solver that is not physics with a unit of its own: what it is, of which
 * kind, and what breaks without it.
 *
 * source: physics with a source.  guard: against rounding or for the grid; the result does not
 * hang on it, or converges as the voxel does.  fitted: chosen so that tests come out, which are
 * named. */
#ifndef CR_SOLVER_TUNING_H
#define CR_SOLVER_TUNING_H

/* guard: half width of the band in which a surface is known, of the part of it that is kept true
 * while the surface moves, and of the core in which two surfaces are compared, voxels. The
 * interpolation between voxels reaches one further than the core. */
static const double cr_band_voxels = 3.5, cr_kept_voxels = 2.75, cr_core_voxels = 1.3;
/* guard: what is left of a voxel below this share of it does not hide the voxels behind it. */
static const double cr_crumb = 0.05;
/* guard: a surface that comes along at less than this cosine of its motion is passed by, not
 * pressed on: the rounding of two fields that slide along each other is no pressure. */
static const double cr_passed_by = 0.05;
/* fitted: which of two structures gives way. They are stronger when they are crushed faster, by an
 * exponent of 0.02 to 0.03 (1.1 to 1.3 at 15 m/s against static tests), and their strength differs
 * from place to place, so that where nearly equal ones meet both give way somewhere. 0.08 stands
 * for both: at 0.03 the ripple of a force over the voxels decides, and the split of the demo hangs
 * on the slice; the crash tests do not tell the two apart. */
static const double cr_rate_exponent = 0.08;
/* guard: a structure that would give way by less than 2e-9 of the overlap, the logarithm of whose
 * odds this is, gives nothing: what rounding took of it opened contacts. */
static const double cr_odds_most = 20;
/* guard: overlap that is left over from before is taken away at most this much faster than the
 * surfaces approach there, so that the force is that of the structure: strength times width. */
static const double cr_pass_most = 1.1;
/* guard: a force ripples as line after line of voxels is met: its level is that over so many voxels
 * of the way, and from this share of the mean force on it is no unloading. */
static const double cr_ripple_voxels = 2, cr_whole_force = 0.7;
/* fitted: the beam of an end and what stands on it hangs together between its rails, up to this
 * share of the half width; beyond, wing and wheel house are dragged along less, by this slope. */
static const double cr_rails_share = 0.43, cr_beyond_rails = 3;
/* fitted: a contact drags a face along as far as its force looks at it: not at all from 60 degrees
 * off the way inward on, wholly within 41 (cosines). Without it oblique hits turn a flank too much:
 * 46 of the 57 targets hold. */
static const double cr_drags_none = 0.5, cr_drags_whole = 0.75;
/* guard: a place so many times deeper behind a face than the nearest outline is the side of a dent
 * in another face, at twice that wholly; and what lies so many voxels deeper than its line is open
 * is behind material that still stands. */
static const double cr_other_face = 4, cr_hidden_voxels = 2.5;
/* guard: depths of a line that differ by less are one, m: behind an engine a flat face holds and
 * tows its lines at one depth, and rounding would decide which of the two a line does. */
static const double cr_one_depth = 1e-9;
/* guard: a place further than this share of a line's width from its middle is not on it: half of it
 * but for rounding, so that a place between two lines is on neither. */
static const double cr_beside = 0.499;
/* guard: depth over which an engine is met whose front is not even, m. */
static const double cr_block_rise = 0.1;
/* fitted: sheet metal and bars that crush each other interlock (0.55 in SMAC, up to 0.8 in staged
 * crashes): 1.0 is what leads the delta-v of the car-to-car tests; on a smooth rigid surface sheet
 * metal slides: 0.13 is what leads the fleet past the edge of a rigid barrier as in 398 tests with
 * 25 % overlap. */
static const double cr_friction_hooked = 1.0, cr_friction_smooth = 0.13;
/* guard: a force closer to the surface than this cosine has no approach that could be divided
 * by. */
static const double cr_cosine_least = 1e-4;
/* guard: approach below which no contact begins, m/s: rounding after a contact. */
static const double cr_begin_speed = 1e-3;
/* guard: share of the plastic impulse that may be missing when the threshold counts as reached. */
static const double cr_threshold_reached = 1e-4;
/* source: structures leave gaps behind the bumper and before the wheel: a contact is over when this
 * long a way or time passed without crush, m and s. */
static const double cr_gap_path = 0.35, cr_gap_time = 0.05;
/* source: definition. A touch that takes less than this share of the pair's crush energy is rubbing
 * of bodies that turn away, not the crash: where they last touched, and elsewhere. Restitution
 * leaves two bodies at most 0.33 of their speed, 0.1 of its energy: what comes back to the same
 * place with more was pushed by a third body, and nothing hangs on how two that hook into each
 * other let go. */
static const double cr_rubbing_here = 0.1, cr_rubbing_elsewhere = 0.001;
/* source: corners and curved ends lag behind: from this share of an end's width on it is whole. */
static const double cr_whole_width = 0.95;
/* guard: approach of two bodies in one slice, voxels. */
static const double cr_approach_voxels = 1;
/* guard: half the size of a contact patch, m: what turns about the COE within it counts as
 * approach. */
static const double cr_patch_reach = 0.75;
/* guard: slices of free motion after a contact are up to this many times longer. */
static const double cr_free_stretch = 4;
/* source: limits of the elastic phases where the force decides, s; the paper takes 5 ms. */
static const double cr_elastic_least = 5e-3, cr_elastic_most = 0.03;
/* guard: so often the force along the surface is lessened that would give back more than friction
 * took. The first try comes to it but for rounding (225 of 225 in 190 random crashes of three or
 * more), which no number of tries takes away. */
static const int cr_rub_tries = 3;
/* source: definition. How long after the last contact another touch belongs to the same crash, s: a
 * pile-up is one crash, and so is the other end of a car that slaps the same wall. Two bodies that
 * both move and have parted are waited for less: whether they slap at all later than that hangs on
 * the last digit. And the step in which it is looked for. */
static const double cr_horizon = 0.3, cr_again = 0.1, cr_probe_step = 0.01;
/* source: definition. A touch foreseen is waited for if its energy of approach is this share of the
 * crash so far, and it is this far from the last one on both bodies, m: further than half a dent is
 * wide. */
static const double cr_strike_share = 0.003, cr_elsewhere = 1.2;
/* guard: slower than this a body is at rest, m/s and rad/s. */
static const double cr_rest_speed = 0.05, cr_rest_yaw = 0.02;
/* guard: plan area that two bodies may share at the start without being called overlapping, m2: the
 * voxels of an outline stand out by up to half an edge. */
static const double cr_overlap_area_most = 0.01;
/* guard: the way out of an overlap is looked for in steps, to a resolution, m; going back is
 * worth so many times the way straight apart. */
static const double cr_way_step = 0.25, cr_way_resolution = 0.01, cr_way_worth = 3;

/* guard: faster than this, or spinning faster, m/s and rad/s, a slice could not be made short
 * enough; far beyond what the scene reader lets through. And half the ground that a wall covers,
 * m. */
static const double cr_speed_most = 1e4, cr_wall_extent = 1e4;
/* guard: rows within this of an instant say course and yaw rate, s: two noisy rows alone do not. */
static const double cr_fit_half = 0.075;
/* source: passenger tyres on dry road have their full lateral force at 6 to 10 deg (our choice
 * among them), and the slope, beyond the tangent 0.1405 of that angle, from which the angle need
 * not be known. */
static const double cr_slip_full_deg = 8, cr_slope_full = 0.15;
/* guard: below this speed friction fades (method.md), and the least rolling speed in the slip
 * angle, m/s. */
static const double cr_speed_soft = 0.1, cr_slip_speed = 0.5;
/* source: our choice. So long after its first contact a car has nobody at the pedals and a gear in,
 * s. */
static const double cr_coast_after = 1;

#endif
