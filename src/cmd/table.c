/* The one table of commands: arguments, help, examples and handlers. Completion, help, the man
 * page and the binding of arguments all read it. */
#include "cmd/cmd_priv.h"

#include <math.h>

#define END                                                                                        \
    { .name = NULL }
#define KEY_OF(word, scene_key, kinds)                                                             \
    { .name = word, .place = CR_ARG_KEY, .type = CR_VALUE_KEY, .key = scene_key, .mask = kinds }
#define POSITION(word, kind, ...)                                                                  \
    { .name = word, .place = CR_ARG_POSITION, .type = kind, __VA_ARGS__ }
#define OPTION(word, kind, ...)                                                                    \
    { .name = word, .place = CR_ARG_OPTION, .type = kind, __VA_ARGS__ }
#define KEY(word, kind, ...)                                                                       \
    { .name = word, .place = CR_ARG_KEY, .type = kind, __VA_ARGS__ }
#define FLAG(word, ...)                                                                            \
    { .name = word, .place = CR_ARG_FLAG, .type = CR_VALUE_TEXT, __VA_ARGS__ }
#define REST(word, kind, ...)                                                                      \
    { .name = word, .place = CR_ARG_REST, .type = kind, __VA_ARGS__ }

#define PAIR_SETUP                                                                                 \
    "vehicle A type=suv mass=2260kg speed=56km/h\n"                                                \
    "vehicle B type=mini-compact mass=1060kg speed=56km/h\n"                                       \
    "place B facing A overlap=40%\n"
#define WALL_SETUP                                                                                 \
    "vehicle A type=compact mass=1400kg speed=50km/h\n"                                            \
    "object wall kind=wall\n"                                                                      \
    "place wall facing A gap=0.2m\n"
/* the test behind share/tutorial/reference.json */
#define NHTSA_7292                                                                                 \
    "vehicle A type=sedan mass=1735kg length=5.022m wheelbase=2.75m cg=1.118m speed=113.4km/h\n"   \
    "vehicle B type=sedan mass=1730kg length=5.020m wheelbase=2.75m cg=1.108m\n"                   \
    "place B facing A overlap=25% side=left angle=-7deg\n"
#define SOLVED PAIR_SETUP "solve\n"

#define V   CR_FOR_VEHICLE
#define O   CR_FOR_OBJECT
#define ANY CR_FOR_ALL

static const struct cr_arg vehicle_args[] = {
    POSITION("NAME", CR_VALUE_NEW, .help = "its name, new or known"),
    KEY_OF("car", "car", V),
    KEY_OF("type", "type", V),
    KEY_OF("built", "built", V),
    KEY_OF("mass", "mass_kg", V),
    KEY_OF("kerb", "kerb_mass_kg", V),
    KEY_OF("load", "load_kg", V),
    KEY_OF("length", "length_m", V),
    KEY_OF("width", "width_m", V),
    KEY_OF("height", "height_m", V),
    KEY_OF("wheelbase", "wheelbase_m", V),
    KEY_OF("track", "track_m", V),
    KEY_OF("overhang", "front_overhang_m", V),
    KEY_OF("cg", "cg.behind_front_axle_m", V),
    KEY_OF("cgheight", "cg.height_m", V),
    KEY_OF("inertia", "yaw_inertia_kgm2", V),
    KEY_OF("speed", "speed_kmh", V),
    KEY_OF("v", "speed_kmh", V),
    KEY_OF("yawrate", "yaw_rate_deg_s", V),
    KEY_OF("brake", "brake", V),
    KEY_OF("steer", "steer_deg", V),
    KEY_OF("locked", "locked", V),
    KEY_OF("brakeafter", "brake_after.deceleration_mps2", V),
    KEY_OF("reaction", "brake_after.reaction_s", V),
    KEY_OF("friction", "friction", V),
    FLAG("remove", .help = "take it out of the scene"),
    END,
};

static const struct cr_arg object_args[] = {
    POSITION("NAME", CR_VALUE_NEW, .help = "its name, new or known"),
    KEY_OF("kind", "shape", O),
    KEY_OF("barrier", "barrier", CR_FOR_BARRIER),
    KEY("diameter", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0.02, .hi = 100,
        .help = "of a pole", .def = "0.254m"),
    KEY_OF("length", "length_m", CR_FOR_BOX),
    KEY_OF("width", "width_m", CR_FOR_BOX),
    KEY_OF("edge", "edge_radius_m", CR_FOR_BOX),
    KEY("low", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = -1, .hi = 100,
        .help = "lower edge above the road", .def = "0m"),
    KEY("high", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = -1, .hi = 100,
        .help = "upper edge above the road", .def = "3m"),
    KEY("mass", CR_VALUE_NUMBER, .dim = CR_DIM_MASS, .unit = "kg", .lo = 0.1, .hi = 1e7,
        .words = "fixed", .help = "or fixed to the ground", .def = "fixed"),
    KEY_OF("friction", "friction", O),
    KEY_OF("speed", "speed_kmh", O),
    KEY_OF("v", "speed_kmh", O),
    FLAG("remove", .help = "take it out of the scene"),
    END,
};

static const struct cr_arg model_args[] = {
    POSITION("NAME", CR_VALUE_VEHICLE, .words = "list|info",
             .help = "a vehicle; list names all models, info MODEL tells where one comes from"),
    OPTION("MODEL", CR_VALUE_MODEL, .help = "TYPE, TYPE/CLOCK or a file of own voxels"),
    KEY_OF("pdof", "model.pdof", V),
    KEY_OF("pdof_clock", "model.pdof_clock", V),
    KEY_OF("pdof_deg", "model.pdof_deg", V),
    KEY_OF("blend", "model.blend", V),
    KEY("front", CR_VALUE_TEXT, .help = "CRASH3 stiffness A,B of the front in N/m, N/m2"),
    KEY("side", CR_VALUE_TEXT, .help = "CRASH3 stiffness A,B of the sides in N/m, N/m2"),
    KEY("rear", CR_VALUE_TEXT, .help = "CRASH3 stiffness A,B of the rear in N/m, N/m2"),
    END,
};

static const struct cr_arg place_args[] = {
    POSITION("NAME", CR_VALUE_NAME, .help = "who is placed"),
    OPTION("HOW", CR_VALUE_WORD, .words = "facing|behind|beside|hitting",
           .help =
               "facing: front to front; behind: its front at the other's rear; beside: flank to "
               "flank; hitting: its front at the other's side, or its side at a pole"),
    OPTION("OTHER", CR_VALUE_NAME, .help = "against whom"),
    KEY("overlap", CR_VALUE_NUMBER, .unit = "%", .lo = 1, .hi = 100, .def = "100%",
        .help = "lateral overlap, % of the narrower width"),
    KEY("side", CR_VALUE_WORD, .words = "left|right|centre|front|rear",
        .help = "which half of the other is met, or which side is struck"),
    KEY("at", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0, .hi = 30,
        .words = "front-axle|A-pillar|B-pillar|rear-axle|cg|middle", .def = "middle",
        .help = "struck side: distance behind the front end, or a named place"),
    KEY("angle", CR_VALUE_NUMBER, .dim = CR_DIM_ANGLE, .unit = "deg", .lo = -360, .hi = 360,
        .def = "0deg",
        .help = "turned counter-clockwise about the first touch; a flank at a pole: from the "
                "heading to the direction of travel (90deg)"),
    KEY("gap", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0, .hi = 500, .def = "0m",
        .help = "free distance before the first touch"),
    KEY("x", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = -1e5, .hi = 1e5,
        .help = "east"),
    KEY("y", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = -1e5, .hi = 1e5,
        .help = "north"),
    KEY_OF("heading", "heading_deg", ANY),
    KEY_OF("course", "course_deg", ANY),
    KEY_OF("speed", "speed_kmh", ANY),
    KEY_OF("v", "speed_kmh", ANY),
    KEY_OF("yawrate", "yaw_rate_deg_s", ANY),
    END,
};

static const struct cr_arg move_args[] = {
    POSITION("NAME", CR_VALUE_NAME, .help = "who is moved"),
    KEY("dx", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = -1e5, .hi = 1e5,
        .def = "0m", .help = "east"),
    KEY("dy", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = -1e5, .hi = 1e5,
        .def = "0m", .help = "north"),
    KEY("turn", CR_VALUE_NUMBER, .dim = CR_DIM_ANGLE, .unit = "deg", .lo = -360, .hi = 360,
        .def = "0deg", .help = "counter-clockwise"),
    KEY("speed", CR_VALUE_NUMBER, .dim = CR_DIM_SPEED, .unit = "km/h", .lo = -500, .hi = 500,
        .def = "0km/h", .help = "added to its speed"),
    END,
};

static const struct cr_arg set_args[] = {
    OPTION("SETTING", CR_VALUE_TEXT, .help = "one of the keys, to be told its value"),
    KEY_OF("method", "method", 0),
    KEY_OF("dt", "dt_ms", 0),
    KEY_OF("voxel", "voxel_mm", 0),
    KEY_OF("restitution", "restitution", 0),
    KEY_OF("friction", "friction", 0),
    KEY_OF("road", "road_friction", 0),
    KEY_OF("elastic", "elastic_ms", 0),
    KEY_OF("end", "end", 0),
    KEY_OF("injury", "injury", 0),
    KEY_OF("slope", "slope_percent", 0),
    KEY_OF("downhill", "downhill_deg", 0),
    KEY_OF("rolling", "rolling_resistance", 0),
    KEY_OF("surface", "surface.vertices_m", 0),
    KEY_OF("road2", "surface.friction", 0),
    KEY_OF("induced", "induced", 0),
    KEY_OF("heights", "heights", 0),
    KEY_OF("dive", "dive", 0),
    KEY_OF("residual", "residual_curve", 0),
    KEY_OF("plane", "plane_normal", 0),
    KEY("name", CR_VALUE_TEXT, .help = "name of the scene"),
    KEY("pair", CR_VALUE_TEXT,
        .help = "name that joins two scenes: the same crash with and without a safety system"),
    KEY("units", CR_VALUE_WORD, .words = CR_UNITS_WORDS, .def = "si",
        .help = "of tables, plots, pictures and reports; us: mph, ft, in, lb, lbf, ft-lb"),
    KEY("echo", CR_VALUE_SWITCH, .words = "on|off", .def = "off",
        .help = "scripts show their lines"),
    KEY("ascii", CR_VALUE_SWITCH, .words = "on|off", .help = "pictures of plain ASCII"),
    KEY("color", CR_VALUE_WORD, .words = "none|16|256", .help = "colours of pictures"),
    END,
};

static const struct cr_arg no_args[] = {END};

static const struct cr_arg check_args[] = {
    OPTION("WHAT", CR_VALUE_WORD, .words = "robust",
           .help = "solve the solved scene again with grid, time slice, place (1 mm) and mass "
                   "(0.5 %) nudged, and tell how far each number moves"),
    KEY("solves", CR_VALUE_COUNT, .lo = 3, .hi = 100, .def = "8", .help = "how often"),
    END,
};

static const struct cr_arg solve_args[] = {
    KEY("until", CR_VALUE_TIME, .dim = CR_DIM_TIME, .unit = "ms", .lo = 0, .hi = 60000,
        .words = "compression|end", .def = "end",
        .help = "where the picture stands then: ms after the first contact, or a phase"),
    FLAG("step", .help = "go on by one time slice and tell about it"),
    FLAG("trace", .help = "list the time slices"),
    END,
};

static const struct cr_arg show_args[] = {
    KEY("field", CR_VALUE_WORD, .words = CR_FIELD_WORDS, .def = "ees",
        .help = "what the voxels show"),
    KEY("time", CR_VALUE_TIME, .dim = CR_DIM_TIME, .unit = "ms", .lo = 0, .hi = 60000,
        .words = "start|compression|end", .def = "end", .help = "ms after the first contact"),
    KEY("frame", CR_VALUE_COUNT, .lo = -1e6, .hi = 1e6,
        .help = "time slice; with a sign so many further or back"),
    KEY("vectors", CR_VALUE_SWITCH, .words = "on|off", .def = "on",
        .help = "arrows of velocity and force"),
    KEY("ghost", CR_VALUE_SWITCH, .words = "on|off", .def = "off",
        .help = "outlines of where everybody was at the first contact"),
    KEY("scale", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0.005, .hi = 10,
        .words = "auto|in|out", .def = "auto", .help = "m per column"),
    KEY("centre", CR_VALUE_POINT, .dim = CR_DIM_LENGTH, .unit = "m",
        .help = "x,y in the middle of the picture"),
    KEY("follow", CR_VALUE_WORD, .words = "cog|world", .def = "cog",
        .help = "keep the bodies in the middle, or the place"),
    KEY("select", CR_VALUE_NAME, .words = "none", .help = "participant to mark"),
    KEY("view", CR_VALUE_WORD, .words = "plan|side|top|front|slice", .def = "plan",
        .help = "plan: the scene; else the selected vehicle's 3D model, with its damage"),
    KEY("colormap", CR_VALUE_WORD, .words = CR_COLORMAP_WORDS, .def = "viridis",
        .help = "colours of the field"),
    END,
};

static const struct cr_arg play_args[] = {
    OPTION("HOW", CR_VALUE_WORD, .words = "on|off", .def = "on", .help = "from the frame shown"),
    KEY("rate", CR_VALUE_NUMBER, .lo = 0.1, .hi = 4, .def = "1",
        .help = "0.1 to 4 times as fast as the crash in six seconds"),
    KEY("loop", CR_VALUE_SWITCH, .words = "on|off", .def = "off", .help = "again and again"),
    END,
};

static const struct cr_arg view_args[] = {
    OPTION("PANE", CR_VALUE_WORD, .words = CR_AREA_WORDS, .help = "what is in front"),
    KEY("zoom", CR_VALUE_SWITCH, .words = "on|off", .def = "off", .help = "the pane alone"),
    KEY("picture", CR_VALUE_COUNT, .lo = 0, .hi = 12, .def = "0",
        .help = "of a sweep, its curve or map in place of the table (0)"),
    KEY("theme", CR_VALUE_WORD, .words = "auto|dark|light|contrast", .def = "auto",
        .help = "colours of the screen; auto: as the terminal's background needs"),
    END,
};

static const struct cr_arg table_args[] = {
    OPTION("WHAT", CR_VALUE_WORD, .words = "results|inputs|steps|sweep|contacts|impacts",
           .def = "results", .help = "which table"),
    KEY("time", CR_VALUE_TIME, .dim = CR_DIM_TIME, .unit = "ms", .lo = 0, .hi = 60000,
        .words = "end", .help = "results at this time after the first contact"),
    KEY("every", CR_VALUE_COUNT, .lo = 1, .hi = 100000, .def = "10",
        .help = "steps: each so manyth"),
    END,
};

static const struct cr_arg pulse_args[] = {
    OPTION("NAME", CR_VALUE_NAME, .words = "all", .def = "all", .help = "whose"),
    OPTION("QUANTITY", CR_VALUE_WORD,
           .words = "a|ax|ay|v|vx|vy|yaw|yawrate|yawacc|x|y|force|energy", .def = "a",
           .help = "what is drawn over the time"),
    KEY("vs", CR_VALUE_FILE, .words = ".csv|.EV5|.mme|.zip|.nnn",
        .help = "measured curve over the time; units as in t_ms, ax_g, v_kmh; or a crash test"),
    KEY("column", CR_VALUE_TEXT, .help = "its column; else that of the quantity, or the first"),
    KEY("filter", CR_VALUE_WORD, .words = "none|cfc60|cfc180|cfc600|cfc1000", .def = "cfc60",
        .help = "channel class of SAE J211, of accelerations"),
    END,
};

static const struct cr_arg explain_args[] = {
    OPTION("TIME", CR_VALUE_TIME, .dim = CR_DIM_TIME, .unit = "ms", .lo = 0, .hi = 60000,
           .words = "first|peak|last", .def = "the slice shown", .help = "after the first contact"),
    KEY("slice", CR_VALUE_COUNT, .lo = 1, .hi = 1e6, .help = "number of the time slice"),
    END,
};

static const struct cr_arg compare_args[] = {
    OPTION("FILE", CR_VALUE_FILE, .words = ".json|.csv|.EV5|.mme|.zip|.nnn",
           .help = "measured values, a curve, a crash test (or its folder), or another result"),
    REST("EVIDENCE=VALUE ...", CR_VALUE_TEXT,
         .help = "in place of a file, as fit takes it: rest.A=12,3m, dv.B=43+-4km/h, "
                 "crush.A=12,14,20,22,18,10cm ..."),
    KEY("within", CR_VALUE_NUMBER, .unit = "%", .lo = 0, .hi = 1000,
        .help = "largest error of a value that passes; of evidence, share of its tolerance"),
    KEY("of", CR_VALUE_NAME, .help = "whose pulse, where more than one moves"),
    KEY("column", CR_VALUE_TEXT, .help = "of the pulse, or channel; else the first, or at the CG"),
    KEY("axis", CR_VALUE_WORD, .words = "forward|left", .def = "forward", .help = "of the pulse"),
    KEY("sign", CR_VALUE_WORD, .words = "plus|minus", .def = "plus",
        .help = "minus where rearward or right is positive"),
    KEY("rating", CR_VALUE_NUMBER, .lo = 0, .hi = 1,
        .help = "least rating of ISO/TS 18571 that passes"),
    END,
};

static const struct cr_arg assert_args[] = {
    REST("EXPRESSION", CR_VALUE_TEXT,
         .help = "A.ees == 40km/h +- 2%, B.delta_v > 30km/h, stop == momentum"),
    END,
};

static const struct cr_arg sweep_args[] = {
    REST("KEY RANGE", CR_VALUE_SWEEP,
         .help = "A.speed 30:80:10km/h, B.overlap 20,40%, B.type suv,compact ...: any inputs, up "
                 "to four in all combinations, up to 12 with draws"),
    KEY("draws", CR_VALUE_COUNT, .lo = 2, .hi = 10000,
        .help = "runs of a Latin hypercube, in place of all combinations; ranges are FROM:TO"),
    KEY("seed", CR_VALUE_COUNT, .lo = 0, .hi = 1e9, .def = "1",
        .help = "of the draws; the same seed draws the same"),
    KEY("jobs", CR_VALUE_COUNT, .lo = 1, .hi = 256, .def = "1", .help = "runs at a time"),
    KEY("out", CR_VALUE_FILE, .words = ".csv", .help = "file for all results"),
    KEY("plot", CR_VALUE_TEXT, .def = "ees of all", .help = "result to draw: A.ees, B.delta_v ..."),
    KEY("row", CR_VALUE_COUNT, .lo = 1, .hi = 100000,
        .help = "take the values of this run of the last sweep into the scene"),
    END,
};

static const struct cr_arg mc_args[] = {
    REST("KEY=VALUE+-TOLERANCE", CR_VALUE_SWEEP,
         .help = "A.speed=56+-3km/h, :uniform or :triangular, @GROUP to move together"),
    KEY("draws", CR_VALUE_COUNT, .lo = 10, .hi = 1000000, .def = "2000",
        .help = "how many scenes are drawn and solved"),
    KEY("seed", CR_VALUE_COUNT, .lo = 1, .hi = 2147483647, .def = "1",
        .help = "of the generator; the same seed gives the same numbers"),
    KEY("sampling", CR_VALUE_WORD, .words = "latin|sobol", .def = "latin",
        .help = "Latin hypercube, or Sobol sequence"),
    KEY("grid", CR_VALUE_WORD, .words = "auto|own", .def = "auto",
        .help = "own: all on the scene's voxels; auto: many on coarse ones"),
    KEY("scatter", CR_VALUE_SWITCH, .words = "on|off", .def = "on",
        .help = "stiffness and what rules assume vary too, as cars of the type differ"),
    KEY("plot", CR_VALUE_TEXT, .def = "ees of all",
        .help = "result of the histogram and the ranked inputs: A.ees, B.delta_v ..."),
    KEY("jobs", CR_VALUE_COUNT, .lo = 1, .hi = 256, .def = "one per processor",
        .help = "solves at a time; the result does not depend on it"),
    KEY("out", CR_VALUE_FILE, .words = ".json|.csv",
        .help = "file for the statistics (.json) or all draws (.csv)"),
    END,
};

static const struct cr_arg damage_args[] = {
    POSITION("NAME", CR_VALUE_VEHICLE, .help = "whose damage was measured"),
    KEY("face", CR_VALUE_WORD, .words = "front|left|rear|right", .def = "front",
        .help = "the side that was struck"),
    KEY("length", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0.05, .hi = 20,
        .spreads = true, .help = "of the damaged field; with its tolerance: 1.4+-0.05m"),
    KEY("offset", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = -10, .hi = 10,
        .spreads = true, .def = "0m", .help = "of its middle, to the right or forward"),
    KEY("c", CR_VALUE_TEXT,
        .help = "residual depths, evenly over the field from left to right or rear to front: "
                "12,14,20,22,18,10+-2cm; unknown: as in real crashes with such a partner"),
    KEY("outline", CR_VALUE_TEXT,
        .help = "in place of length, offset and c, points ALONG:DEPTH: -70:10,0:30,70:20cm"),
    KEY("direct", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0.02, .hi = 20,
        .def = "the field", .help = "width of what was struck directly"),
    KEY("at", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = -10, .hi = 10,
        .def = "as offset", .help = "middle of what was struck directly"),
    KEY("pdof", CR_VALUE_NUMBER, .dim = CR_DIM_ANGLE, .unit = "deg", .lo = -360, .hi = 360,
        .spreads = true, .def = "square to the face",
        .help = "direction of the force, clockwise from ahead: 350+-10deg"),
    KEY("ride", CR_VALUE_WORD, .words = "under|over",
        .help = "under: went under its partner, struck above the bumpers; over: rode up"),
    KEY("low", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0, .hi = 4, .def = "0m",
        .help = "heights that were struck, from"),
    KEY("high", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0.1, .hi = 5,
        .def = "the roof", .help = "to"),
    KEY("tape", CR_VALUE_NUMBER, .dim = CR_DIM_LENGTH, .unit = "m", .lo = 0, .hi = 0.5,
        .def = "3cm", .help = "tolerance of the depths, 95 %"),
    KEY("against", CR_VALUE_NAME, .def = "who else was measured",
        .help = "partner: a measured vehicle, or an object of the scene"),
    FLAG("solved", .help = "compare with the solved deformation, station by station"),
    FLAG("picture", .help = "the outline over the voxels, from above and from the side"),
    KEY("out", CR_VALUE_FILE, .words = ".json", .help = "file for what follows"),
    END,
};

static const struct cr_arg fit_args[] = {
    REST("KEY ... to EVIDENCE ...", CR_VALUE_SWEEP,
         .help =
             "inputs to search for (A.speed, B.overlap=20%:60%), then what was measured: "
             "dv.A=43km/h, ees.B, crush.A=12,14,20,22,18,10cm, rest.A=12,3m, other results; with "
             "+- or a usual tolerance"),
    KEY("starts", CR_VALUE_COUNT, .lo = 1, .hi = 20, .def = "3",
        .help = "local searches, from the best of a coarse look"),
    KEY("solves", CR_VALUE_COUNT, .lo = 20, .hi = 100000, .def = "400", .help = "most in all"),
    KEY("seed", CR_VALUE_COUNT, .lo = 1, .hi = 2147483647, .def = "1",
        .help = "of the coarse look"),
    KEY("out", CR_VALUE_FILE, .words = ".json", .help = "file for the findings"),
    FLAG("take", .help = "put the best values into the scene"),
    END,
};

static const struct cr_arg load_args[] = {
    OPTION("FILE", CR_VALUE_FILE, .words = ".json", .help = "scene"),
    FLAG("recover", .help = "the scene of a session that ended by a crash"),
    END,
};

static const struct cr_arg save_args[] = {
    OPTION("FILE", CR_VALUE_FILE, .words = ".json", .help = "scene; without one, where it was"),
    END,
};

static const struct cr_arg export_args[] = {
    POSITION("WHAT", CR_VALUE_STEM,
             .words =
                 "result|scene|field|pulse|steps|sweep|report|before|contact|engagement|after|"
                 "energy|damage|side|top|front|risk|histogram|tornado|overview|channels|motion|"
                 "body|film",
             .help = "what is written; with a suffix (after.svg) it is the file as well"),
    OPTION("FILE", CR_VALUE_FILE,
           .words = ".csv|.json|.txt|.html|.svg|.pdf|.png|.mme|.gp|.vtk|.obj|.cast",
           .help = "its suffix says how"),
    KEY("of", CR_VALUE_VEHICLE, .help = "vehicle of damage, side, top, front, risk and body"),
    KEY("time", CR_VALUE_TIME, .dim = CR_DIM_TIME, .unit = "ms", .lo = 0, .hi = 60000,
        .words = "start|compression|end", .def = "as shown",
        .help = "of the scene, ms after the first contact"),
    KEY("plot", CR_VALUE_TEXT, .def = "ees of all",
        .help = "result of a sweep or of mc to draw: A.ees, B.delta_v ..."),
    KEY("axes", CR_VALUE_WORD, .words = "iso8855|sae", .def = "iso8855",
        .help = "of the motion: y north and counter-clockwise, or y south and clockwise"),
    KEY("every", CR_VALUE_NUMBER, .dim = CR_DIM_TIME, .unit = "ms", .lo = 0.1, .hi = 10000,
        .def = "10", .help = "step of the motion"),
    KEY("lang", CR_VALUE_WORD, .words = "en|de", .def = "en", .help = "language of the report"),
    KEY("author", CR_VALUE_TEXT, .help = "of the report: who answers for it"),
    KEY("case", CR_VALUE_TEXT, .help = "of the report: case number"),
    KEY("draws", CR_VALUE_COUNT, .lo = 0, .hi = 100000, .def = "300",
        .help = "for the intervals of the report; 0: none"),
    KEY("tests", CR_VALUE_WORD, .words = "on|off", .def = "on",
        .help = "crash tests like the crash in the report, solved for comparison"),
    END,
};

static const struct cr_arg source_args[] = {
    POSITION("FILE", CR_VALUE_FILE, .words = ".crumple", .help = "command file"),
    END,
};

static const struct cr_arg count_args[] = {
    OPTION("COUNT", CR_VALUE_COUNT, .lo = 1, .hi = 1e6, .def = "1", .help = "how many"),
    END,
};

static const struct cr_arg history_args[] = {
    OPTION("COUNT", CR_VALUE_COUNT, .lo = 1, .hi = 1e6, .def = "all", .help = "the last so many"),
    END,
};

static const struct cr_arg name_args[] = {
    POSITION("NAME", CR_VALUE_NAME, .help = "a participant"),
    END,
};

static const struct cr_arg copy_args[] = {
    POSITION("NAME", CR_VALUE_NAME, .help = "the original"),
    POSITION("NEW", CR_VALUE_NEW, .help = "name of the copy"),
    END,
};

static const struct cr_arg help_args[] = {
    OPTION("COMMAND", CR_VALUE_COMMAND,
           .help = "a command, a term (pdof, olc, cdc), units or glossary; without one all "
                   "commands are listed"),
    END,
};

static const struct cr_arg apropos_args[] = {
    POSITION("WORD", CR_VALUE_TEXT, .help = "searched in names, keys and help"),
    END,
};

static const struct cr_arg new_args[] = {
    OPTION("NAME", CR_VALUE_TEXT, .help = "name of the new scene"),
    END,
};

#define ROW(word, kind, args, line)                                                                \
    .name = #word, .group = kind, .arg = args, .help = line, .run = cr_cmd_##word
#define SCENE "Scene"
#define SOLVE "Solving and understanding"
#define LOOK  "Looking"
#define FILES "Files"
#define SELF  "Session"

static const struct cr_command commands[] = {
    {ROW(vehicle, SCENE, vehicle_args, "add a vehicle, change it, or tell about it"),
     .example = {"vehicle A type=suv mass=2260kg speed=56km/h", "vehicle A"},
     .setup = "vehicle A type=suv\n", .see = "object model place"},
    {ROW(object, SCENE, object_args,
         "add a wall, pole, box or barrier, change it, or tell about it"),
     .example = {"object tree kind=pole diameter=0.4m", "object front barrier=odb"},
     .see = "vehicle place"},
    {ROW(model, SCENE, model_args, "choose the EES model of a vehicle, or list the models"),
     .example = {"model B mini-compact/12", "model info suv/12"}, .setup = PAIR_SETUP,
     .see = "vehicle"},
    {ROW(place, SCENE, place_args, "put a participant somewhere, or against another"),
     .example = {"place B facing A overlap=40% side=right gap=0.5m",
                 "place A x=0 y=0 heading=0 speed=56km/h"},
     .setup = PAIR_SETUP, .see = "move"},
    {ROW(move, SCENE, move_args, "move or turn a participant from where it is"),
     .example = {"move B dy=0.1m", "move B turn=5deg"}, .setup = PAIR_SETUP "move B dx=1m\n",
     .see = "place"},
    {ROW(set, SCENE, set_args, "change a setting; alone it lists all"),
     .example = {"set restitution=0.1 dt=0.5ms", "set echo on"}, .flags = CR_CMD_PAIRS,
     .see = "check"},
    {ROW(list, SCENE, no_args, "list the participants"), .example = {"list", "list"},
     .setup = PAIR_SETUP, .see = "vehicle object"},
    {ROW(remove, SCENE, name_args, "take a participant out of the scene"),
     .example = {"remove B", "remove A"}, .setup = PAIR_SETUP, .see = "undo"},
    {ROW(copy, SCENE, copy_args, "add a copy of a participant"),
     .example = {"copy A C", "copy B D"}, .setup = PAIR_SETUP, .see = "place"},
    {ROW(new, SCENE, new_args, "begin an empty scene (undo brings the old one back)"),
     .example = {"new", "new offset"}, .see = "load undo"},

    {ROW(check, SOLVE, check_args,
         "tell what is missing or doubtful, with the command that mends it; robust: what hangs on "
         "chance"),
     .example = {"check", "check robust solves=3"}, .setup = SOLVED, .see = "solve mc"},
    {ROW(solve, SOLVE, solve_args, "compute the crash"), .example = {"solve", "solve --step"},
     .setup = PAIR_SETUP, .see = "show table explain"},
    {ROW(explain, SOLVE, explain_args,
         "Eq. (1) to (5) of the paper for one time slice, with the numbers of this crash"),
     .example = {"explain 20ms", "explain slice=1"}, .setup = SOLVED, .see = "solve table"},
    {ROW(sweep, SOLVE, sweep_args, "solve for ranges of inputs: all combinations, or draws"),
     .example = {"sweep A.speed 40:60:20km/h", "sweep B.overlap 40%:100%:60% jobs=2 plot=B.ees"},
     .setup = PAIR_SETUP, .see = "table solve"},
    {ROW(mc, SOLVE, mc_args,
         "solve many draws of uncertain inputs: intervals, and what they depend on"),
     .example = {"mc A.speed=56+-3km/h B.overlap=40+-5% draws=50",
                 "mc B.mass=1060+-50kg:uniform draws=50 sampling=sobol"},
     .setup = PAIR_SETUP, .see = "sweep solve"},
    {ROW(damage, SOLVE, damage_args,
         "work back from a measured deformation: EES, delta-v, closing speed"),
     .example = {"damage A face=front length=1.4m c=12,14,20,22,18,10cm",
                 "damage B length=1.2+-0.1m c=30,25,20+-2cm pdof=350+-10deg"},
     .setup = PAIR_SETUP, .see = "fit compare"},
    {ROW(fit, SOLVE, fit_args, "search inputs that explain measured damage, recorders, rest"),
     .example = {"fit A.speed to dv.A=30km/h starts=1 solves=30",
                 "fit A.speed=40:70km/h B.overlap=30%:60% to ees.B=60km/h dv.A=30+-3km/h starts=1 "
                 "solves=40"},
     .setup = PAIR_SETUP, .see = "sweep mc compare"},
    {ROW(compare, SOLVE, compare_args,
         "the result beside measured values, or beside another result"),
     .example = {"compare share/tutorial/reference.json",
                 "compare share/validation/data/taurus_7292_veh1_pulse.csv of=A"},
     .setup = NHTSA_7292 "solve\n", .see = "assert pulse"},
    {ROW(assert, SOLVE, assert_args, "stop with status 1 unless a result is as expected"),
     .example = {"assert A.ees == 45km/h +- 50%", "assert B.delta_v > A.delta_v"}, .setup = SOLVED,
     .see = "compare"},

    {ROW(show, LOOK, show_args, "draw the scene, before, at a time, or after"),
     .example = {"show field=energy time=30ms", "show frame=+10"}, .setup = SOLVED,
     .see = "view pulse table"},
    {ROW(view, LOOK, view_args, "choose the pane in front; at a plain prompt it is printed"),
     .example = {"view pulse", "view scene zoom=on"}, .setup = SOLVED, .see = "show"},
    {ROW(play, LOOK, play_args, "play the crash in slow motion (full screen)"),
     .example = {"play rate=0.5 loop=on", "play off"}, .setup = SOLVED, .see = "show view"},
    {ROW(table, LOOK, table_args, "print a table of results, inputs, time slices or a sweep"),
     .example = {"table", "table steps every=20"}, .setup = SOLVED, .see = "show pulse"},
    {ROW(pulse, LOOK, pulse_args, "draw acceleration, speed or another quantity over the time"),
     .example = {"pulse", "pulse B ax filter=cfc60"}, .setup = SOLVED, .see = "table compare"},

    {ROW(load, FILES, load_args, "read a scene"),
     .example = {"load share/scenes/q7-fiat500.json", "load share/scenes/pole-side.json"},
     .see = "save source"},
    {ROW(save, FILES, save_args, "write the scene; ! overwrites another file"),
     .example = {"save mine.json", "save! mine.json"}, .setup = PAIR_SETUP, .flags = CR_CMD_FORCE,
     .see = "load export"},
    {ROW(export, FILES, export_args, "write results, fields, pulses or pictures; ! overwrites"),
     .example = {"export! result mine.csv", "export! pulse mine.csv"}, .setup = SOLVED,
     .flags = CR_CMD_FORCE, .see = "save"},
    {ROW(source, FILES, source_args, "run a command file"),
     .example = {"source share/tutorial/1-first-crash.crumple",
                 "source share/tutorial/2-ees-and-delta-v.crumple"},
     .see = "load"},

    {ROW(pause, SELF, no_args, "in a command file: wait until somebody presses Enter"),
     .example = {"pause", "pause"}, .see = "source play"},
    {ROW(undo, SELF, count_args, "take back the last changes of the scene"),
     .example = {"undo", "undo 2"}, .setup = PAIR_SETUP, .see = "redo history"},
    {ROW(redo, SELF, count_args, "bring back what undo took"), .example = {"redo", "redo 1"},
     .setup = PAIR_SETUP "undo 2\n", .see = "undo"},
    {ROW(history, SELF, history_args, "list the lines typed so far"),
     .example = {"history", "history 10"}, .see = "undo"},
    {ROW(help, SELF, help_args, "list the commands, or explain one, or a term of the field"),
     .example = {"help pdof", "help place"}, .see = "apropos"},
    {ROW(apropos, SELF, apropos_args, "find commands and terms by a word of their help"),
     .example = {"apropos speed", "apropos overlap"}, .see = "help"},
    {ROW(quit, SELF, no_args, "end the session; ! without asking"), .example = {"quit", "quit!"},
     .flags = CR_CMD_FORCE, .see = "save"},
};

const struct cr_command *cr_commands(int *n) {
    *n = (int)(sizeof commands / sizeof commands[0]);
    return commands;
}

const struct cr_command *cr_command_find(const char *word, bool *many) {
    int n;
    const struct cr_command *table = cr_commands(&n);
    return cr_command_among(table, n, word, many);
}
