#include "core/formats/glsl_sampler.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/formats/glsl_text.h"

namespace nacre {
namespace {

constexpr std::size_t row = 1024;  // texels, as shaders/uniforms.glsl has it

}  // namespace

std::vector<float> sampler_data(const Tables& tables) {
    std::vector<float> data = tables.data;
    const std::vector<float> sampling = sampling_table(tables).values;
    data.insert(data.end(), sampling.begin(), sampling.end());
    return data;
}

int texture_rows(std::size_t numbers) {
    return static_cast<int>((std::max<std::size_t>(numbers, 1) + row - 1) / row);
}

void add_float(std::string& bytes, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(static_cast<unsigned char>(bits >> shift & 255u));
}

std::string texture_bytes(std::span<const float> numbers) {
    std::string bytes;
    for (const float value : numbers) add_float(bytes, value);
    bytes.resize(static_cast<std::size_t>(texture_rows(numbers.size())) * row * 4);
    return bytes;
}

std::string glsl_sampler_text(const Design& design, const Tables& tables, const std::string& prefix) {
    const SamplingTable sampling = sampling_table(tables);
    const std::string about = fmt::format(
        "// uniform sampler2D {}_data: the tables, {} x {} texels of one 32-bit float (R32F), not "
        "filtered.\n",
        prefix, row, texture_rows(tables.data.size() + sampling.values.size()));
    return glsl_function(design, tables, prefix, sampler_fetch("data") + "\n", about, &sampling);
}

}  // namespace nacre
