// The sampling that exports carry, as the C header has it: what it draws is as dense as it says, and is what
// the BRDF needs.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/formats/c_header.h"
#include "core/formats/sampling_table.h"
#include "tests/core/cheap.h"
#include "tests/core/compiled_c.h"
#include "tests/core/export_designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

// For each direction k2 of the input: the mean of rho cos/density, its standard error, the share of samples
// that are above the horizon, the integral of the density, the largest deviation of a bin in standard errors,
// and how often something was wrong. A bin's mean of cos/(pi density) is the bin's own share of the cosine:
// there are 32 that have the same.
constexpr const char* sample_design = R"(
#include "design.h"
#include <stdint.h>
#include <stdio.h>

#define SAMPLES 100000
#define BINS 32
static const double pi = 3.14159265358979323846;
static uint64_t state = 1;

static double uniform(void) {
    uint64_t x = (state += 0x9e3779b97f4a7c15u);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return (double)((x ^ (x >> 31)) >> 11) / 9007199254740992.0;
}

static int bin_of(const nacre_real* k) {
    int row = (int)(4 * (1 - (double)(k[2] * k[2])));
    int column = (int)(8 * (atan2((double)k[1], (double)k[0]) / (2 * pi) + 0.5));
    return (row > 3 ? 3 : row) * 8 + (column > 7 ? 7 : column);
}

static double integral(const nacre_real* k2) {
    double sum = 0;
    int i, j;
    for (i = 0; i < 500; ++i)
        for (j = 0; j < 1000; ++j) {
            double z = (i + 0.5) / 500, sine = sqrt(1 - z * z), azimuth = 2 * pi * (j + 0.5) / 1000;
            nacre_real k1[3];
            k1[0] = (nacre_real)(sine * cos(azimuth));
            k1[1] = (nacre_real)(sine * sin(azimuth));
            k1[2] = (nacre_real)z;
            sum += (double)nacre_pdf(k1, k2) * 2 * pi / 500000;
        }
    return sum;
}

static void measure(const nacre_real* k2, double* result) {
    double sum[3] = {0}, square[3] = {0}, bin[BINS] = {0}, bin_square[BINS] = {0};
    double kept = 0, wrong = 0, worst = 0;
    int i, c;
    for (i = 0; i < SAMPLES; ++i) {
        nacre_real u[3], k1[3], rho[3], density;
        double even;
        for (c = 0; c < 3; ++c) u[c] = (nacre_real)(uniform() * 0.9999999);
        density = nacre_sample(k2, u, k1);
        if (!(density > 0)) {
            wrong += k1[2] > 0;
            continue;
        }
        kept += 1;
        wrong += density != nacre_pdf(k1, k2) || !(k1[2] > 0);
        nacre_brdf(k1, k2, rho);
        for (c = 0; c < 3; ++c) {
            double value = (double)rho[c] * (double)k1[2] / (double)density;
            sum[c] += value;
            square[c] += value * value;
        }
        even = (double)k1[2] / pi / (double)density;
        bin[bin_of(k1)] += even;
        bin_square[bin_of(k1)] += even * even;
    }
    for (i = 0; i < BINS; ++i) {
        double mean = bin[i] / SAMPLES, error = sqrt((bin_square[i] / SAMPLES - mean * mean) / SAMPLES);
        double off = fabs(mean - 1.0 / BINS) / error;
        worst = off <= worst ? worst : off;
    }
    for (c = 0; c < 3; ++c) {
        double mean = sum[c] / SAMPLES;
        result[c] = mean;
        result[3 + c] = sqrt((square[c] / SAMPLES - mean * mean) / SAMPLES);
    }
    result[6] = kept / SAMPLES;
    result[7] = integral(k2);
    result[8] = worst;
    result[9] = wrong;
}

int main(int count, char** words) {
    FILE* in = fopen(words[count - 2], "rb");
    FILE* out = fopen(words[count - 1], "wb");
    double given[3], result[10];
    while (fread(given, sizeof(double), 3, in) == 3) {
        nacre_real k2[3];
        int i;
        for (i = 0; i < 3; ++i) k2[i] = (nacre_real)given[i];
        measure(k2, result);
        fwrite(result, sizeof(double), 10, out);
    }
    fclose(in);
    return fclose(out);
}
)";

constexpr std::size_t numbers_each = 10;

std::vector<double> probes_in_a_row() {
    std::vector<double> numbers;
    for (const dvec3& k : probes) numbers.insert(numbers.end(), {k.x, k.y, k.z});
    return numbers;
}

// The lobes are wide enough for a quadrature of half a million directions.
const std::set<std::string> wide{"matt facets", "film", "shot", "retro"};

void check_samples(const std::string& name, const Brdf& brdf, const std::vector<double>& measured) {
    REQUIRE(measured.size() == std::size(probes) * numbers_each);
    for (std::size_t i = 0; i < std::size(probes); ++i) {
        CAPTURE(i);
        const double* found = &measured[i * numbers_each];
        const dvec3 albedo = brdf.total_albedo(probes[i]);
        for (int c = 0; c < 3; ++c) CHECK(std::fabs(found[c] - albedo[c]) <= 5 * found[3 + c] + 2e-3);
        CHECK(found[6] > 0.3);
        CHECK(found[8] < 5);
        CHECK(found[9] == 0);
        if (wide.count(name)) CHECK(found[7] == doctest::Approx(found[6]).epsilon(0.005));
    }
}

}  // namespace

TEST_SUITE_BEGIN("sampling of exports");

// What it runs is compiled apart, and has no sanitizer.
TEST_CASE("samples are as dense as they say, and their mean is the albedo" * doctest::skip(cheap)) {
    for (const ExportDesign& one : export_designs()) {
        const Design& design = one.design;
        CAPTURE(one.name);
        const auto tables = bake(design, {.albedo = true});
        for (const char* form : {"", " -DNACRE_FLOAT"}) {
            CAPTURE(form);
            const CompiledC program({{"design.h", c_header(design, *tables)}}, sample_design,
                                    strict_c + std::string(form));
            REQUIRE(program.said == "");
            check_samples(one.name, Brdf(tables), program(probes_in_a_row()));
        }
    }
}

TEST_CASE("the table is the same each time, and its bounds rise") {
    const auto tables = bake(matt_facets());
    const SamplingTable table = sampling_table(*tables), again = sampling_table(*tables);
    CHECK(table.values == again.values);
    CHECK(table.columns > 1);
    const auto rises = [&](std::size_t first, std::size_t count) {
        return std::is_sorted(table.values.begin() + static_cast<std::ptrdiff_t>(first),
                              table.values.begin() + static_cast<std::ptrdiff_t>(first + count),
                              std::less_equal<>());
    };
    const std::size_t rows = static_cast<std::size_t>(table.rows);
    const std::size_t columns = static_cast<std::size_t>(table.columns);
    REQUIRE(table.values.size() == 2 * (rows + 1) + rows * (columns + 1));
    CHECK(rises(0, rows + 1));
    CHECK(rises(rows + 1, rows + 1));
    for (std::size_t i = 0; i < rows; ++i) CHECK(rises(2 * (rows + 1) + i * (columns + 1), columns + 1));
    CHECK(sampling_table(*bake(design_of(GgxLobe{0.1, 0.1}))).columns == 1);
}

TEST_SUITE_END();
