#include "core/verify/close_albedo.h"

#include "core/model/merged_facets.h"

namespace nacre {
namespace {

constexpr std::size_t summed_one_by_one = 1 << 17;  // facets at most
constexpr std::size_t cells_of_more = 25600;

bool many(const Reference& reference) { return count_facets(reference.layers()) > summed_one_by_one; }

// Merged facets have no layers, whose tints R would need.
std::shared_ptr<const FacetDistribution> merged_if_many(const Reference& reference) {
    if (many(reference) && reference.layout().tint != Tint::varied)
        return merge_facets(reference.layers(), reference.distribution());
    return {std::shared_ptr<const void>(), &reference.distribution()};
}

}  // namespace

CloseAlbedo::CloseAlbedo(const Reference& reference, double tolerance)
    : reference_(reference),
      distribution_(merged_if_many(reference)),
      albedo_(*distribution_, tolerance,
              many(reference) ? cells_of_more / distribution_->lobes().size() : 0) {}

AlbedoValues CloseAlbedo::operator()(dvec3 k, std::stop_token stop) const {
    return albedo_(
        {reference_.shading(), k, distribution_->projected_area(k), reference_.channels()},
        [&](dvec3 k2) { return distribution_->projected_area(k2); }, stop);
}

}  // namespace nacre
