#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/pictures/examined.h"
#include "core/pictures/exr_blocks.h"
#include "core/pictures/picture_problem.h"
#include "core/pictures/primaries.h"

namespace nacre {
void examine_exr(const FileBytes& file, Examined& found) {
    const ExrHeaders headers = read_exr_headers(file);
    const ExrHeader& first = headers.parts[0];
    if (headers.is_deep) throw PictureProblem("its pixels are deep, flat ones are read");
    if (!first.subsampled.empty())
        throw PictureProblem(
            one_line(fmt::format("its channels {} have fewer samples than pixels, as luminance "
                                 "and chroma have; R, G, B or Y are read",
                                 fmt::join(first.subsampled, ", ")),
                     300));
    if (first.is_cube) throw PictureProblem("a cube map, not a lat-long picture");
    check_exr_blocks(file, headers);
    const auto& display = first.display_window;
    found.size = glm::dvec2(display[2] - display[0], display[3] - display[1]) + 1.0;
    found.pieces = headers.pieces;
    if (first.chromaticities) found.to_rec709 = to_rec709(*first.chromaticities);
    if (headers.parts.size() > 1)
        found.notes.push_back(one_line(
            fmt::format("the first of its {} parts is used, \"{}\"", headers.parts.size(), first.name), 100));
}

}  // namespace nacre
