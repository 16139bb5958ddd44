// Where g integrates: the facets that face n are all of those above the horizon.
#include <fmt/core.h>

#include "core/model/facet_distribution.h"
#include "core/study/paper_designs.h"
#include "core/study/paper_parts.h"

namespace nacre {
namespace {

PaperResult make(const PaperTools&) {
    const FacetDistribution p(paper_gaussian(0.1, 1).distribution);
    PaperResult result;
    result.tables = {{{"g(n)/N"}, {{fmt::format("{:.3f}", p.projected_area({0, 0, 1}) / p.mean_cosine())}}}};
    return result;
}

}  // namespace

const PaperPart figure_4_part{.name = "figure-4",
                              .title = "Figure 4: the domain of g",
                              .where = "fig. 4",
                              .says = "Integration domain for g(k).",
                              .make = make};

}  // namespace nacre
