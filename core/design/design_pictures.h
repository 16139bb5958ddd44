// The pictures of a design: painted layers and modulations.
#pragma once

#include <fmt/core.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/design/design.h"

namespace nacre {

// visit(picture, where) of every one, with its path in the design file.
template <class AnyDesign, class Visit>
void for_each_picture(AnyDesign& design, const Visit& visit) {
    static_assert(std::is_same_v<std::remove_const_t<AnyDesign>, Design>);
    auto& layers = design.distribution.layers;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string where = fmt::format("distribution.layers[{}]", i);
        visit_pictures(layers[i].lobe, [&](auto& picture, std::string_view key) {
            visit(picture, fmt::format("{}.{}", where, key));
        });
        if (layers[i].modulation) visit(layers[i].modulation->image, where + ".modulation.image");
    }
}

// The design with these files read again. What is wrong is a UserError of the design `error_file`.
Design with_pictures_reread(Design design, const std::vector<std::filesystem::path>& files,
                            const std::string& error_file);

// The design with these pictures embedded, as they were read, in place of their files.
Design with_pictures_held(Design design, const std::vector<std::filesystem::path>& files);

}  // namespace nacre
