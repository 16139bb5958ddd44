// Text on a picture, in the interface's typeface.
#pragma once

#include <memory>
#include <string>

#include "app/preview/render.h"

struct ImFontAtlas;

namespace nacre::cli {

// Letters are drawn at twice their size and averaged down, so that they stand where they should to half a
// pixel.
class CaptionFont {
  public:
    explicit CaptionFont(int pixels);  // height of a line
    ~CaptionFont();
    CaptionFont(const CaptionFont&) = delete;
    CaptionFont& operator=(const CaptionFont&) = delete;

    // The text, or as much of it as fits with an ellipsis, centred at x under y.
    void draw(RenderedImage& image, const std::string& utf8, double x, int y, double width_max,
              float grey) const;

  private:
    std::unique_ptr<ImFontAtlas> atlas_;
};

}  // namespace nacre::cli
