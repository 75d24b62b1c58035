#include "scene/scene.h"

/* Natural frequency of a loaded car on its springs, Hz, and the share of the dive that the
 * suspension's geometry takes away. Textbook values of passenger cars (1.1-1.5 Hz, 20-50 %): our
 * assumption, no source of this project gives them. */
static const double ride_hz = 1.3, anti_dive = 0.35;

double cr_scene_dive(const struct cr_participant *p, double road_friction) {
    double braking = 0;
    for (int i = 0; i < CR_WHEELS; i++) {
        braking += (p->locked[i] ? 1 : p->brake[i]) / CR_WHEELS;
    }
    double rear_arm = p->wheelbase - p->cg_behind_front_axle;
    double front = p->mass * rear_arm / p->wheelbase, rear = p->mass - front;
    /* load that goes to the front axle: m a h / wheelbase */
    double shift = p->mass * CR_G * road_friction * braking * p->cg_height / p->wheelbase;
    double per_mass =
        4 * CR_PI * CR_PI * ride_hz * ride_hz; /* spring rate of an axle per kg on it */
    double down = shift / (front * per_mass), up = shift / (rear * per_mass);
    double nose = down + (down + up) / p->wheelbase * p->front_overhang;
    return (1 - anti_dive) * nose;
}
