/* The BRDF of pairs of directions: reads lines `k1x k1y k1z k2x k2y k2z`, unit vectors with z along the
   normal, and prints red, green and blue in 1/sr; then how much of the light from straight above is
   reflected, by sampling.

       nacre-cli export presets/brushed-gold.nacre --to c --prefix gold -o gold.h
       cc -std=c99 -I. examples/evaluate.c -o evaluate -lm
       echo 0 0 1 0.6 0 0.8 | ./evaluate */
#include <stdio.h>
#include <stdlib.h>

#include "gold.h"

static double uniform(void) { return rand() / (RAND_MAX + 1.0); }

int main(void) {
    const int samples = 100000;
    const gold_real k2[3] = {0, 0, 1};
    double reflected = 0;
    double k[6];
    int i;
    while (scanf("%lf %lf %lf %lf %lf %lf", k, k + 1, k + 2, k + 3, k + 4, k + 5) == 6) {
        gold_real to_light[3], to_viewer[3], rho[3];
        for (i = 0; i < 3; ++i) {
            to_light[i] = (gold_real)k[i];
            to_viewer[i] = (gold_real)k[3 + i];
        }
        gold_brdf(to_light, to_viewer, rho);
        printf("%.9g %.9g %.9g\n", (double)rho[0], (double)rho[1], (double)rho[2]);
    }
    for (i = 0; i < samples; ++i) {
        gold_real u[3], k1[3], rho[3], density;
        u[0] = (gold_real)uniform();
        u[1] = (gold_real)uniform();
        u[2] = (gold_real)uniform();
        density = gold_sample(k2, u, k1);
        if (density <= 0) continue; /* the sample is lost, which counts as black */
        gold_brdf(k1, k2, rho);
        reflected += (double)(rho[0] * k1[2] / density) / samples;
    }
    printf("reflects %.3f of red light\n", reflected);
    return 0;
}
