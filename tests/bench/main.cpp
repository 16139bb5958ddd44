// nacre-bench: how long Nacre takes against other ways to the same result. The table of ratios goes to
// standard error, so that standard output is Google Benchmark's alone, whatever its format.
#include <benchmark/benchmark.h>

#include "tests/bench/subjects.h"

int main(int count, char** values) {
    using namespace nacre::bench;
    Report report;
    add_evaluation(report);
    add_sampling(report);
    add_multibounce(report);
    add_facets(report);
    add_coat(report);
    add_area(report);
    add_lobe_area(report);
    add_albedo(report);
    add_bake(report);
    benchmark::Initialize(&count, values);
    if (benchmark::ReportUnrecognizedArguments(count, values)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    report.print(stderr);
    return 0;
}
