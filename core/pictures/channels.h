// Which of a file's channels are its picture.
#pragma once

#include <string>
#include <vector>

namespace nacre {

enum class PictureUse {
    light,  // facets or radiance: colours, each times its alpha once
    data    // numbers, such as normals or heights; without regard to alpha
};

struct Channels {
    std::vector<int> colour;  // 1 grey, 2 red and green as data, or 3
    int alpha = -1;
    std::string note;  // what is left out, or empty
};

// By their names: R, G and B, or Y, alone or in one layer with the name of a finished picture. A
// PictureProblem that says what there is where none is plainly that. `named`: the format names its channels,
// else one alone is the picture.
Channels choose_channels(const std::vector<std::string>& names, PictureUse use, bool named);

}  // namespace nacre
