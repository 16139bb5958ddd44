// Many pictures on one, each with its name below it.
#pragma once

#include <string>
#include <vector>

#include "app/preview/render.h"

namespace nacre::cli {

// Of one sheet: eight rows of eight are as many as a screen shows.
inline constexpr std::size_t sheet_pictures_max = 64;

class ContactSheet {
  public:
    // All pictures are of one size. Only a thumbnail of it is kept.
    void add(std::string name, const RenderedImage& image);

    bool empty() const { return thumbnails_.empty(); }
    bool full() const { return thumbnails_.size() >= sheet_pictures_max; }

    // The sheet of what was added, which is forgotten; one picture at least.
    RenderedImage take();

  private:
    struct Thumbnail {
        std::string name;
        RenderedImage image;
    };
    std::vector<Thumbnail> thumbnails_;
};

}  // namespace nacre::cli
