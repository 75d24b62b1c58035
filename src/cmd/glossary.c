/* The words of the field that results are told in: what each is, its unit, its formula and who
 * defined it. */
#include "cmd/cmd_priv.h"

#include "base/units.h"

#include <string.h>
#include <strings.h>

/* name, other names between |, title, definition, unit, formula, source. Formulas are as this
 * program computes them; share/doc/method.md has the whole of it. */
static const struct term {
    const char *name, *others, *title, *meaning, *unit, *formula, *source;
} terms[] = {
    {"ees", "energy equivalent speed", "Energy Equivalent Speed",
     "speed at which the vehicle would have to meet a rigid wall to take up the same energy by "
     "lasting deformation",
     "km/h", "EES = sqrt(2 E / m), E: energy of all crushed voxels, m: mass as crashed",
     "Burg and Zeidler 1980; Eq. (1) of the paper"},
    {"delta-v", "dv|delta_v|deltav", "Delta-v",
     "size of the change of velocity of the centre of gravity by an impact; of several impacts the "
     "sum of the sizes, never netted; the net vector stands beside it",
     "km/h", "delta-v = |sum of F dt| / m over the contact", "ISO 12353-1"},
    {"pdof", "direction of force", "Principal Direction Of Force",
     "direction from which the impulse came, clockwise from ahead in the vehicle's own frame, also "
     "as hour of the clock (12: from ahead, 3: from the right)",
     "deg, o'clock", "PDOF = atan2(delta-v to the left, -delta-v forward)", "SAE J224"},
    {"cdc", "collision deformation classification", "Collision Deformation Classification",
     "seven signs: hour of the PDOF (2), face (F R B L), place along it (D L C R Y Z), heights (A "
     "E "
     "...), kind (W wide, N narrow, S sideswipe), extent zone 1 to 9",
     "", "for example 12FDEW3: from ahead, front, distributed, below the belt line, wide, zone 3",
     "SAE J224"},
    {"coe", "centre of energy|center of energy", "Centre Of Energy",
     "where the force of a time slice acts: mean place of the voxels that yield, each weighed by "
     "its energy",
     "m", "COE = sum(E_voxel p_voxel) / sum(E_voxel)", "Eq. (3) of the paper"},
    {"olc", "occupant load criterion", "Occupant Load Criterion",
     "severity of a pulse for a belted occupant: the constant deceleration that brings an occupant "
     "who flew on freely for 65 mm to the speed of the vehicle within the next 235 mm",
     "g", "OLC = (v0 - v(t2)) / (t2 - t1); t1: 65 mm of free flight, t2: 300 mm in all",
     "Kuebler et al. 2009, Euro NCAP TB 027"},
    {"asi", "acceleration severity index", "Acceleration Severity Index",
     "greatest of the 50 ms means of acceleration, each direction against its limit", "",
     "ASI = max sqrt((ax/12 g)^2 + (ay/9 g)^2), means over 50 ms; the vertical is left out",
     "EN 1317-1"},
    {"thiv", "theoretical head impact velocity", "Theoretical Head Impact Velocity",
     "speed with which a free head meets the inside of the car, 0.6 m ahead or 0.3 m to the side",
     "km/h", "THIV = |v_head - v_car| where the head has moved 0.6 m or 0.3 m in the car",
     "EN 1317-1"},
    {"phd", "post-impact head deceleration", "Post-impact Head Deceleration",
     "greatest 10 ms mean of the car's acceleration after the head has met its inside", "g",
     "PHD = max |mean over 10 ms of a| from the time of THIV on", "EN 1317-1"},
    {"vpi", "vehicle pulse index", "Vehicle Pulse Index",
     "greatest acceleration of a 1 kg occupant on a belt of 2500 N/m with 0.03 m of slack", "m/s2",
     "VPI = max |x''| of x'' = -k max(x - slack, 0) relative to the car", "ISO/TR 12353-3"},
    {"pulse", "crash pulse|acceleration_mean", "Crash pulse",
     "acceleration over time; its length is the time with at least 5 % of the greatest "
     "acceleration (CFC 60), without rubbing",
     "ms", "mean acceleration = delta-v / length", "SAE J211-1 for the filter"},
    {"cfc", "filter|cfc60", "Channel Frequency Class",
     "low-pass filter without shift of phase that accelerations are shown with", "Hz",
     "CFC 60: four poles in all (two forward, two backward), 3 dB at 100 Hz", "SAE J211-1"},
    {"restitution", "coefficient of restitution|e", "Restitution",
     "what comes back of the impulse of compression: 0 plastic, 1 elastic; auto: from closing "
     "speed, kind of partner and width",
     "", "e = impulse of restitution / impulse of compression", "Poisson; method.md"},
    {"friction", "coefficient of friction|mu", "Friction between bodies",
     "largest tangential over normal force; auto: vehicles hook into each other (1.0), on smooth "
     "objects they slide (0.1)",
     "", "|F_t| <= mu F_n", "Coulomb; method.md"},
    {"overlap", "lateral overlap", "Overlap",
     "share of the narrower width in which two fronts meet", "%",
     "overlap = common width / width of the narrower vehicle", "ISO 12353-1"},
    {"closing-speed", "closing|closing speed|closing velocity", "Closing speed",
     "speed of approach of the two at the place and along the normal of first contact", "km/h",
     "v_rel . n at first contact", "ISO 12353-1"},
    {"induced", "induced deformation|indirect", "Induced deformation",
     "what is bent beside the contact because it hangs together with what is struck", "m, kJ", "",
     "SAE J224 (direct and induced damage)"},
    {"c1-c6", "c1|c6|crush profile|profile", "Crush profile C1 to C6",
     "residual depths at six places evenly over the damaged width, from a straight line along the "
     "foremost points of the undeformed face, at the height of the force",
     "m", "equivalent mean: (C1/2 + C2 + C3 + C4 + C5 + C6/2) / 5",
     "Campbell 1974, CRASH3; SAE J2433"},
    {"stiffness", "a|b|crash3", "Stiffness coefficients A, B",
     "force per width of a face over its residual depth C", "N/m, N/m2",
     "F/w = A + B C; energy per width A C + B C^2/2 + A^2/(2 B)", "Campbell 1974, CRASH3"},
    {"depth", "deformation_max|crush|deformation", "Greatest depth",
     "deepest mean over 0.1 m of the struck face, square to it, after springback; the dynamic one "
     "before",
     "m", "max over 0.1 m windows of the mean depth", "method.md"},
    {"mais", "ais|risk|injury", "Risk of injury, MAIS",
     "probability that the worst injury of an occupant is at least of this grade (2 moderate, 3 "
     "serious); by the severest impact; set injury= chooses the functions",
     "%", "P = 1 / (1 + exp(-(b0 + b1 delta-v + ...)))", "AAAM AIS; share/irf names each study"},
    {"heading", "course|sideslip", "Heading and course",
     "heading: where the vehicle looks; course: where its centre of gravity moves; both "
     "counter-clockwise from x (east)",
     "deg", "sideslip angle = course - heading", "ISO 8855"},
    {"yaw-rate", "yaw rate|yaw|yaw_rate_change|yawrate", "Yaw rate",
     "angular velocity about the vertical, counter-clockwise", "deg/s",
     "change = moment of the impulse about the CG / yaw inertia", "ISO 8855"},
    {"kerb-mass", "kerb|load|mass|kerb mass", "Kerb mass and load",
     "kerb mass: what the structure was built for, its strength goes by it; load: occupants and "
     "cargo; mass: both, momentum and inertia go by it",
     "kg", "mass = kerb mass + load", "ISO 1176"},
    {"voxel", "ees model|voxels", "Voxel",
     "cell of a vehicle's model with the energy that crushing it takes; so small that the result "
     "does not hang on it",
     "mm", "E_voxel = m (EES_behind^2 - EES_before^2) / 2", "the paper"},
    {"stop", "stop criterion", "Stop criterion",
     "why compression ended: momentum (the approach is used up), separation, no-overlap (nothing "
     "left to crush)",
     "", "", "the paper; method.md"},
    {"balance", "residual|momentum", "Balance",
     "what went in against what came out: kinetic energy before = after + deformation + friction + "
     "tyres; the rest is an error of the solver",
     "kJ", "residual = |in - out| / in", "method.md"},
    {"robust", "resolved|not-resolved|spread", "Robust, resolved",
     "does a number stay when grid, time slice, place (1 mm) and mass (0.5 %) are nudged? A spread "
     "above 5 % is not resolved: give an interval",
     "%", "spread = half the range of all solves / number", "check robust; method.md"},
    {"iso-18571", "rating|iso/ts 18571", "ISO/TS 18571 rating",
     "how well two curves agree: corridor, phase, magnitude and slope, 0 to 1", "",
     "R = 0.4 Z + 0.2 E_P + 0.2 E_M + 0.2 E_S", "ISO/TS 18571"},
    {"cora", "correlation", "CORA rating",
     "the older rating of two curves by corridor and cross-correlation, 0 to 1", "", "",
     "Gehre et al. 2009"},
};
enum { TERMS = sizeof terms / sizeof terms[0] };

/* is it the name, or one of the others, in any case? */
static bool is_called(const struct term *t, const char *word) {
    size_t len = strlen(word);
    if (strcasecmp(t->name, word) == 0 || strcasecmp(t->title, word) == 0) {
        return true;
    }
    for (const char *s = t->others; s != NULL && *s != '\0';) {
        size_t n = strcspn(s, "|");
        if (n == len && strncasecmp(s, word, n) == 0) {
            return true;
        }
        s += n + (s[n] == '|');
    }
    return false;
}

static void say_term(struct cr_session *s, const struct term *t) {
    static const char *const heads[] = {"unit", "formula", "source"};
    const char *const texts[] = {t->unit, t->formula, t->source};
    struct cr_str page = {0};
    cr_str_addf(&page, "%s (%s): ", t->title, t->name);
    cr_help_fold(&page, t->meaning, (int)page.len, 2);
    for (int i = 0; i < 3; i++) {
        if (texts[i][0] != '\0') {
            cr_str_addf(&page, "  %-8s ", heads[i]);
            cr_help_fold(&page, texts[i], 11, 11);
        }
    }
    cr_session_lines(s, &page, false);
    cr_str_fini(&page);
}

/* all units by what they measure */
static void say_units(struct cr_session *s) {
    struct cr_str page = {0};
    cr_str_add(&page,
               "A number may have its unit behind it, without a blank: 56km/h, 25.4mm, 3500lb.\n"
               "Without one it is in the usual unit, the first that help COMMAND names.\n");
    for (int dim = CR_DIM_NUMBER; dim < CR_DIMS; dim++) {
        const struct cr_unit *unit;
        struct cr_str list = {0};
        for (int i = 0; (unit = cr_unit_nth((enum cr_dim)dim, i)) != NULL; i++) {
            if (unit->name[0] != '\0') {
                cr_str_addf(&list, "%s%s", list.len > 0 ? " " : "", unit->name);
            }
        }
        cr_str_addf(&page, "  %-28s ", cr_dim_word((enum cr_dim)dim));
        page.failed = page.failed || list.failed;
        cr_help_fold(&page, cr_str_get(&list), 31, 31);
        cr_str_fini(&list);
    }
    cr_str_add(&page,
               "Angles are counter-clockwise from x (east) but for the PDOF, which is clockwise "
               "from\nahead.\n");
    cr_session_lines(s, &page, false);
    cr_str_fini(&page);
}

bool cr_glossary_say(struct cr_session *s, const char *word) {
    if (strcasecmp(word, "units") == 0 || strcasecmp(word, "unit") == 0) {
        say_units(s);
        return true;
    }
    if (strcasecmp(word, "glossary") == 0) {
        for (int i = 0; i < TERMS; i++) {
            cr_say(s, "%-14s %s", terms[i].name, terms[i].title);
        }
        cr_say(s, "help NAME explains one; help units lists the units");
        return true;
    }
    for (int i = 0; i < TERMS; i++) {
        if (is_called(&terms[i], word)) {
            say_term(s, &terms[i]);
            return true;
        }
    }
    return false;
}

int cr_glossary_search(struct cr_session *s, const char *word) {
    int found = 0;
    for (int i = 0; i < TERMS; i++) {
        const struct term *t = &terms[i];
        const char *const texts[] = {t->name,    t->others,  t->title,
                                     t->meaning, t->formula, t->source};
        bool hit = false;
        for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
            hit = hit || cr_help_contains(texts[k], word);
        }
        if (hit) {
            say_term(s, t);
            found++;
        }
    }
    return found;
}

const char *cr_glossary_name(int i, const char **title) {
    *title = i < TERMS ? terms[i].title : NULL;
    return i < TERMS ? terms[i].name : NULL;
}
