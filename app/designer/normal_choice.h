// How a picture that comes in is read as a map of normals: what its numbers speak for, and what was chosen.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/paint/normal_map.h"

namespace nacre {

class NormalChoice {
  public:
    // Decodes the picture and keeps it. One that cannot be read has no choices; picture() tells why.
    void look_at(const std::filesystem::path& file);
    void forget_picture() { picture_.reset(); }

    // Rows of the current Dear ImGui window; none where there is nothing to choose.
    void draw();

    // What was looked at. A UserError where it cannot be read.
    const ColourPicture& picture();
    const NormalReading& reading() const { return reading_; }
    const PictureNotes& picture_notes() const { return picture_notes_; }
    PictureNotes notes() const;  // the picture's, after what is to be said of its normals

  private:
    void count();

    std::optional<ColourPicture> picture_;
    PictureNotes picture_notes_;
    NormalMapLook look_;
    NormalReading reading_;
    std::string note_;                                       // on the picture, under this reading
    std::map<std::filesystem::path, NormalReading> chosen_;  // for the session
    bool green_down_ = false;                                // as it was chosen last
    std::filesystem::path file_;
};

}  // namespace nacre
