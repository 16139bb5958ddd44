// What nacre-bench measures; each adds its benchmarks, which add their lines to the report.
#pragma once

#include "tests/bench/report.h"

namespace nacre::bench {

void add_area(Report& report);         // g of a painted p: all of it, and one direction
void add_lobe_area(Report& report);    // g of analytic lobes against cubature
void add_albedo(Report& report);       // R of one direction against Monte Carlo
void add_bake(Report& report);         // all tables of a design, against the paper's way
void add_evaluation(Report& report);   // the BRDF of one pair of directions against closed forms
void add_sampling(Report& report);     // visible facets against spherical caps
void add_facets(Report& report);       // what matt facets cost
void add_multibounce(Report& report);  // what light that bounces between facets costs
void add_coat(Report& report);         // what a clear coat costs

}  // namespace nacre::bench
