// Radiance pictures: the decoder is shown the plainest header, and what the file's own says is done here.
// (Radiance file formats, "Picture File Format")
#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cstdio>

#include "core/base/error.h"
#include "core/pictures/examined.h"
#include "core/pictures/picture_problem.h"
#include "core/pictures/primaries.h"

namespace nacre {
namespace {

constexpr std::uint64_t header_max = 1u << 16;  // bytes

struct Resolution {
    std::array<std::string, 2> axes;  // as "-Y": of the scan lines, and along them
    std::array<double, 2> lengths{};
};

// "-Y 512 +X 1024": lines from the top down, each to the right.
Resolution read_resolution(std::string_view line) {
    Resolution found;
    std::size_t at = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        while (at < line.size() && line[at] == ' ') ++at;
        found.axes[i] = line.substr(at, 2);
        at += 2;
        while (at < line.size() && line[at] == ' ') ++at;
        unsigned length = 0;
        if (at > line.size()) break;
        const auto [end, error] = std::from_chars(line.data() + at, line.data() + line.size(), length);
        if (error == std::errc()) found.lengths[i] = length;
        at = static_cast<std::size_t>(end - line.data());
    }
    return found;
}

// EXIF's orientation for the positions of the first line and the first column.
int orientation_of(const Resolution& resolution) {
    constexpr std::array<std::array<std::string_view, 2>, 8> orders{{{"-Y", "+X"},
                                                                     {"-Y", "-X"},
                                                                     {"+Y", "-X"},
                                                                     {"+Y", "+X"},
                                                                     {"+X", "-Y"},
                                                                     {"-X", "-Y"},
                                                                     {"-X", "+Y"},
                                                                     {"+X", "+Y"}}};
    for (std::size_t i = 0; i < orders.size(); ++i)
        if (orders[i][0] == resolution.axes[0] && orders[i][1] == resolution.axes[1])
            return static_cast<int>(i) + 1;
    return 0;
}

void read_primaries(const std::string& line, Examined& found) {
    std::array<double, 8> xy{};
    if (std::sscanf(line.c_str(), "PRIMARIES=%lf %lf %lf %lf %lf %lf %lf %lf", &xy[0], &xy[1], &xy[2], &xy[3],
                    &xy[4], &xy[5], &xy[6], &xy[7]) == 8)
        found.to_rec709 = to_rec709(xy);
}

}  // namespace

void examine_hdr(const FileBytes& file, Examined& found) {
    const std::string header = file.read(0, header_max);
    std::size_t at = 0;
    const auto next_line = [&] {
        const std::size_t end = header.find('\n', at);
        if (end == header.npos) throw PictureProblem("the HDR file's header is cut short");
        std::string line = header.substr(at, end - at);
        if (line.ends_with('\r')) line.pop_back();
        at = end + 1;
        return line;
    };
    for (std::string line = next_line(); !line.empty(); line = next_line()) {
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            throw PictureProblem(one_line(line, 60) + ", 32-bit_rle_rgbe is read");
        if (line.starts_with("PRIMARIES=")) read_primaries(line, found);
    }
    const std::string line = next_line();
    const Resolution resolution = read_resolution(line);
    found.orientation = orientation_of(resolution);
    if (found.orientation == 0 || resolution.lengths[0] < 1 || resolution.lengths[1] < 1)
        throw PictureProblem("the HDR file's size is \"" + one_line(line, 60) +
                             "\", must be as -Y 512 +X 1024");
    found.size = glm::dvec2(resolution.lengths[1], resolution.lengths[0]);
    found.pieces = {{fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", resolution.lengths[0],
                                 resolution.lengths[1]),
                     0, 0},
                    {{}, at, file.size() - at}};
}

}  // namespace nacre
