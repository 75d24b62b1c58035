/* Mixes the energies along and across a vehicle for the direction that it is loaded from.
 *
 * A sum (u = u_long cos^2 + u_lat sin^2) was tried: with it an oblique blow on a door had to
 * crush a quarter of the far stiffer longitudinal density of the middle of the car, and side poles
 * stopped at half their measured depth. The weaker direction gives way first, so the two are mixed
 * like springs in series, and each layer of the face that the sector loads then gets back exactly
 * its share of 1/2 m EES(d)^2. */
#include "config.h"

#include "model/model_priv.h"

#include <string.h>

/* Energies with 1/E = cos^2 / E_long + sin^2 / E_lat, in scratch; where a direction has no share
 * the other field itself is returned. */
static const double *in_series(const struct cr_model_fields *f, const double share[2],
                               double *scratch) {
    const double *along = f->energy[0], *across = f->energy[1];
    if (share[1] == 0) {
        return along;
    }
    if (share[0] == 0) {
        return across;
    }
    size_t cells = (size_t)f->nx * (size_t)f->half;
    for (size_t i = 0; i < cells; i++) {
        double sum = share[0] * across[i] + share[1] * along[i];
        scratch[i] = sum > 0 ? along[i] * across[i] / sum : 0;
    }
    return scratch;
}

/* Writes into sum, per layer of the loaded face, the factor that brings the mix to the energy that
 * the layer takes. */
static void layer_factors(const struct cr_model_fields *f, bool side, const double *mixed,
                          double *sum) {
    int layers = side ? f->half : f->nx;
    memset(sum, 0, (size_t)layers * sizeof *sum);
    for (int j = 0; j < f->half; j++) {
        const double *row = mixed + (size_t)j * (size_t)f->nx;
        for (int k = 0; k < f->nx; k++) {
            sum[side ? j : k] += row[k];
        }
    }
    for (int i = 0; i < layers; i++) {
        double want = side ? f->layer_y[i] : f->layer_x[i] / 2;
        sum[i] = sum[i] > 0 ? want / sum[i] : 0;
    }
}

void cr_model_mix(const struct cr_model_fields *f, const struct cr_model_sector *sector, int n,
                  double *scratch, double *sum, double *out) {
    size_t nx = (size_t)f->nx, cells = nx * (size_t)f->half;
    memset(out, 0, cells * sizeof *out);
    for (int s = 0; s < n; s++) {
        const double *share = sector[s].share;
        const double *mixed = in_series(f, share, scratch);
        layer_factors(f, sector[s].side, mixed, sum);
        for (int j = 0; j < f->half; j++) {
            for (size_t k = 0; k < nx; k++) {
                size_t i = (size_t)j * nx + k;
                double e = sector[s].part * mixed[i] * sum[sector[s].side ? (size_t)j : k];
                if (f->ranged[0] != NULL) {
                    e *= share[0] * f->ranged[0][i] + share[1] * f->ranged[1][i];
                }
                out[i] += e;
            }
        }
    }
}
