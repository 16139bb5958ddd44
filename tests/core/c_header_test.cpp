// The exported C header: it compiles without a warning, and what it computes is what core computes.
#include "core/formats/c_header.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "tests/core/cheap.h"
#include "tests/core/compiled_c.h"
#include "tests/core/export_designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr const char* evaluate_pairs = R"(
#include "design.h"
#include <stdio.h>

int main(int count, char** words) {
    FILE* in = fopen(words[count - 2], "rb");
    FILE* out = fopen(words[count - 1], "wb");
    double pair[6], result[3];
    while (fread(pair, sizeof(double), 6, in) == 6) {
        nacre_real k1[3], k2[3], rho[3];
        int i;
        for (i = 0; i < 3; ++i) k1[i] = (nacre_real)pair[i];
        for (i = 0; i < 3; ++i) k2[i] = (nacre_real)pair[3 + i];
        nacre_brdf(k1, k2, rho);
        for (i = 0; i < 3; ++i) result[i] = (double)rho[i];
        fwrite(result, sizeof(double), 3, out);
    }
    fclose(in);
    return fclose(out);
}
)";

// Exact in float, so that both forms are asked about the same directions. One in three is near the mirror.
std::vector<double> pairs_of(int count) {
    Random random(7);
    std::vector<double> numbers;
    for (int i = 0; i < count; ++i) {
        const dvec3 k1 = random_direction(random);
        dvec3 k2 = random_direction(random);
        if (i % 3 == 0) k2 = glm::normalize(dvec3{-k1.x, -k1.y, k1.z} + 0.1 * k2);
        for (const dvec3& k : {k1, k2})
            for (int axis = 0; axis < 3; ++axis)
                numbers.push_back(static_cast<double>(static_cast<float>(k[axis])));
    }
    return numbers;
}

struct Worst {
    double relative = 0;  // of the value
    double scaled = 0;    // of the larger of the value and 1e-3 of the design's largest
    double largest = 0;   // value
};

Worst worst_of(const std::vector<double>& found, const std::vector<double>& wanted) {
    Worst worst;
    for (const double value : wanted) worst.largest = std::max(worst.largest, value);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const double error = std::fabs(found[i] - wanted[i]);
        if (!(error <= 0)) worst.relative = std::max(worst.relative, error / wanted[i]);
        worst.scaled = std::max(worst.scaled, error / std::max(wanted[i], 1e-3 * worst.largest));
    }
    return worst;
}

std::vector<double> by_core(const Brdf& brdf, const std::vector<double>& pairs) {
    std::vector<double> values;
    for (std::size_t i = 0; i < pairs.size(); i += 6) {
        const dvec3 rho =
            brdf.evaluate({pairs[i], pairs[i + 1], pairs[i + 2]}, {pairs[i + 3], pairs[i + 4], pairs[i + 5]});
        values.insert(values.end(), {rho.x, rho.y, rho.z});
    }
    return values;
}

}  // namespace

TEST_SUITE_BEGIN("C header");

// What it runs is compiled apart, and has no sanitizer.
TEST_CASE("every part of a design is in the header, in double and in float" * doctest::skip(cheap)) {
    const std::vector<double> pairs = pairs_of(10000);
    for (const ExportDesign& one : export_designs()) {
        const Design& design = one.design;
        CAPTURE(one.name);
        const auto tables = bake(design);
        const std::string header = c_header(design, *tables);
        const std::vector<double> wanted = by_core(Brdf(tables), pairs);

        const CompiledC exact({{"design.h", header}}, evaluate_pairs);
        REQUIRE(exact.said == "");
        const std::vector<double> found = exact(pairs);
        REQUIRE(found.size() == wanted.size());
        const Worst worst = worst_of(found, wanted);
        CHECK(worst.largest > 0);
        CHECK(worst.relative <= 1e-6);

        const CompiledC quick({{"design.h", header}}, evaluate_pairs,
                              std::string(strict_c) + " -DNACRE_FLOAT");
        REQUIRE(quick.said == "");
        // A coat's facets are so narrow that float knows the exponent of their density to 2e-4 only: 1 -
        // 1/c^2 over the square of a width of 0.02.
        const double allowed = is_coated(design.coat) ? 1e-3 : 2e-4;
        CHECK(worst_of(quick(pairs), wanted).scaled <= allowed);
    }
}

TEST_CASE("two designs fit into one program, in C and in C++, one of them in float") {
    const Design gold = design_of(GgxLobe{0.2, 0.4}), velvet = design_of(InverseGaussianLobe{0.5});
    const auto gold_tables = bake(gold), velvet_tables = bake(velvet);
    const std::string source = R"(
#define velvet_FLOAT
#include "gold.h"
#include "velvet.h"
#include "velvet.h"
#include <stdio.h>

int main(int count, char** words) {
    FILE* out = fopen(words[count - 1], "wb");
    const double k1[3] = {0, 0, 1}, k2[3] = {0.6, 0, 0.8};
    const float other1[3] = {0, 0, 1}, other2[3] = {0.6f, 0, 0.8f};
    double rho[6];
    float other[3];
    int i;
    gold_brdf(k1, k2, rho);
    velvet_brdf(other1, other2, other);
    for (i = 0; i < 3; ++i) rho[3 + i] = (double)other[i];
    fwrite(rho, sizeof(double), 6, out);
    return fclose(out);
}
)";
    const dvec3 k1{0, 0, 1}, k2{0.6, 0, 0.8};
    const dvec3 first = Brdf(gold_tables).evaluate(k1, k2), second = Brdf(velvet_tables).evaluate(k1, k2);
    for (const char* compiler : {strict_c, strict_cpp}) {
        const CompiledC both({{"gold.h", c_header(gold, *gold_tables, "gold")},
                              {"velvet.h", c_header(velvet, *velvet_tables, "velvet")}},
                             source, compiler);
        REQUIRE(both.said == "");
        const std::vector<double> rho = both({});
        REQUIRE(rho.size() == 6);
        CHECK(rho[0] == doctest::Approx(first.x).epsilon(1e-9));
        CHECK(rho[3] == doctest::Approx(second.x).epsilon(1e-5));
    }
}

TEST_CASE("every name outside of functions begins with the prefix") {
    const Design design = returning();
    const auto tables = bake(design, {.fit_bounces = false});
    const std::string source = R"(
#define vec3 1
#define select 2
#define half_vector 3
#define Surface 4
#define data 5
#define LARGEST 6
#define MATH 7
#define evaluated_brdf 8
#include "mine.h"
int main(void) { return mine_layer_count > 0 ? 0 : 1; }
)";
    const CompiledC plain({{"mine.h", c_header(design, *tables, "mine")}}, source);
    CHECK(plain.said == "");
}

TEST_CASE("the albedo is in the header where the tables hold R, and nowhere else") {
    const Design design = design_of(GgxLobe{0.3, 0.3});
    const auto with = bake(design, {.albedo = true}), without = bake(design);
    CHECK(c_header(design, *without).find("nacre_albedo(") == std::string::npos);
    const std::string source = R"(
#include "design.h"
#include <stdio.h>
int main(int count, char** words) {
    FILE* out = fopen(words[count - 1], "wb");
    const double k[3] = {0.6, 0, 0.8};
    double albedo[3];
    nacre_albedo(k, albedo);
    fwrite(albedo, sizeof(double), 3, out);
    return fclose(out);
}
)";
    const CompiledC program({{"design.h", c_header(design, *with)}}, source);
    REQUIRE(program.said == "");
    const std::vector<double> found = program({});
    const dvec3 wanted = Brdf(with).total_albedo({0.6, 0, 0.8});
    REQUIRE(found.size() == 3);
    for (int i = 0; i < 3; ++i)
        CHECK(found[static_cast<std::size_t>(i)] == doctest::Approx(wanted[i]).epsilon(1e-9));
}

TEST_SUITE_END();
