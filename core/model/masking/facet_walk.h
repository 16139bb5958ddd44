#pragma once

namespace nacre {

// How light finds its next facet after a bounce (core/model/facet_walks.h).
enum class FacetWalk {
    uncorrelated,  // whatever it met before
    smith          // by its height, as if the facets were strewn in a half space
};

}  // namespace nacre
