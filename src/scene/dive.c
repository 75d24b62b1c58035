/* How far the bumper of a braking vehicle goes down. */
#include "scene/scene.h"

#include "base/elementary.h"

#include <math.h>

/* Natural frequency of a loaded car on its springs, Hz, and the share of the dive that the
 * suspension's geometry takes away. Textbook values of passenger cars (1.1-1.5 Hz, 20-50 %): our
 * assumption, no source of this project gives them. */
static const double ride_hz = 1.3, anti_dive = 0.35;
/* rate of the force on a front that is crushed, 1/s (F = m w^2 x) [WALL-RATE] */
static const double crush_rate = 23.7;

double cr_scene_dive(const struct cr_participant *p, double road_friction, bool front) {
    double braking = 0;
    for (int i = 0; i < CR_WHEELS; i++) {
        braking += (p->locked[i] ? 1 : p->brake[i]) / CR_WHEELS;
    }
    double ahead = p->cg_behind_front_axle, front_mass = p->mass * (1 - ahead / p->wheelbase);
    double rear_mass = p->mass - front_mass;
    /* load that goes to the front axle: m a h / wheelbase */
    double shift = p->mass * CR_G * road_friction * braking * p->cg_height / p->wheelbase;
    /* spring rate of an axle per kg on it, 1/s2 */
    double per_mass = 4 * CR_PI * CR_PI * ride_hz * ride_hz;
    double down = shift / (front_mass * per_mass), up = shift / (rear_mass * per_mass);
    double turn = (down + up) / p->wheelbase;
    double rear_overhang = p->length - p->front_overhang - p->wheelbase;
    double end = front ? down + turn * p->front_overhang : -up - turn * rear_overhang;
    return (1 - anti_dive) * end;
}

double cr_scene_pitch(const struct cr_participant *p, double delta_v, double force_height,
                      bool front) {
    /* F = m w dv sin(w t) turns the body by m w dv lever / I (w t - sin w t) / w^2, and half of the
     * energy is in at w t = pi/4. The springs (1.3 Hz) have no time to answer in these 33 ms. */
    double course = CR_PI / 4 - cr_sin(CR_PI / 4);
    double lever = p->cg_height - force_height;
    double turn = course * p->mass * delta_v * lever / (crush_rate * p->yaw_inertia);
    double nose = p->cg_behind_front_axle + p->front_overhang;
    return turn * (front ? nose : p->length - nose);
}
