#include "core/formats/web_light.h"

#include <algorithm>
#include <cstdint>
#include <glm/gtc/packing.hpp>

#include "core/light/procedural.h"

namespace nacre {
namespace {

constexpr std::size_t order_row = 256;  // texels, as shaders/draw.glsl has it
constexpr double half_max = 65504;

void add_texel(std::string& bytes, glm::vec4 texel) {
    for (int i = 0; i < 4; ++i) add_half(bytes, static_cast<double>(texel[i]));
}

}  // namespace

void add_half(std::string& bytes, double value) {
    const std::uint16_t bits = glm::packHalf1x16(static_cast<float>(value));
    bytes += static_cast<char>(static_cast<unsigned char>(bits & 255u));
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> 8));
}

std::string order_bytes(const DirectionOrder& order) {
    std::string bytes;
    constexpr int step = order_leaf_size / web_leaf_size;
    for (int i = 0; i < order_nodes; ++i) add_texel(bytes, order.texels[static_cast<std::size_t>(i)]);
    for (int i = step / 2; i < order_count; i += step)
        add_texel(bytes, order.texels[static_cast<std::size_t>(order_nodes + i)]);
    constexpr std::size_t row = order_row * 4 * sizeof(std::uint16_t);
    bytes.resize((bytes.size() + row - 1) / row * row);
    return bytes;
}

std::string picture_bytes(const Environment& environment) {
    std::string bytes;
    for (const auto& texel : environment.picture.radiance)
        for (int c = 0; c < 3; ++c) add_half(bytes, std::min(static_cast<double>(texel[c]), half_max));
    return bytes;
}

std::vector<std::shared_ptr<const Environment>> web_environments() {
    std::vector<std::shared_ptr<const Environment>> all;
    for (const char* name : {"studio", "sky"})
        for (const ProceduralEnvironment* kind : procedural_environments())
            if (std::string_view(kind->name) == name)
                all.push_back(make_environment(kind->label, kind->picture(web_environment_width)));
    return all;
}

}  // namespace nacre
