// What a picture that comes in is most likely for.
#pragma once

#include <cstddef>
#include <string>

#include "core/image/picture.h"
#include "core/model/picture_source.h"

namespace nacre {

enum class ImportUse { stamp, normals, heights, modulation, environment };
inline constexpr std::size_t import_uses = 5;

// What is measured of a picture, on some 65,000 of its pixels. Shares are from 0 to 1, of the pixels that are
// not transparent unless said otherwise.
struct PictureStatistics {
    int width = 0, height = 0;
    int channels = 3;
    bool encoded = true;        // integers
    double clear = 0;           // share of all pixels whose alpha is below a tenth
    double grey = 0;            // share whose red, green and blue are within 0.04 of each other
    double black_or_white = 0;  // share within a tenth of 0 or of 1, by the mean of the colours
    double few_colours = 0;     // share that its 16 most frequent colours have, of 16 steps a channel
    double corners = 0;         // mean of the colours beyond the disk that touches the four sides ...
    double disk = 0;            // ... and within it
    double normals = 0;         // share that is a normal of length 1 which faces up, as the numbers are read
    double blue = 0;            // the mean z of these
    double tilt = 0;            // how far their mean is off n: the length of its x and y
};

PictureStatistics picture_statistics(const ColourPicture& picture, const NormalReading& reading);

struct PictureGuess {
    ImportUse use;
    std::string why;  // "it is mostly blue, and nearly all of its normals have length 1"
};

PictureGuess likely_use(const PictureStatistics& picture);

}  // namespace nacre
