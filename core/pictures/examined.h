// What a file is, by its first bytes and its header, before any decoder sees it.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/pictures/file_bytes.h"

namespace nacre {

struct Examined {
    std::string format;                   // OpenImageIO's name of it
    std::vector<Piece> pieces;            // what the decoder is shown; none: the file as it is
    glm::dvec2 size{0, 0};                // pixels as they are stored; 0 where only the decoder can tell
    int orientation = 0;                  // EXIF's 1 to 8; 0 where only the decoder can tell
    bool has_no_alpha = false;            // though the decoder may make one of padding
    bool is_associated = false;           // though the decoder cannot tell: its colours are times alpha
    bool has_runs = false;                // of a palette's colours
    double gamma = 0;                     // of integers, where the file states one; 0: sRGB's curve
    std::optional<glm::dmat3> to_rec709;  // of other primaries
    std::vector<std::string> notes;
};

// A PictureProblem where the file is no picture that is read, or is seen to be damaged.
Examined examine(const FileBytes& file);

// The parts of examine() that a format needs: each fills what it finds.
void examine_png(const FileBytes& file, Examined& found);
void examine_jpeg(const FileBytes& file, Examined& found);
void examine_hdr(const FileBytes& file, Examined& found);
void examine_exr(const FileBytes& file, Examined& found);
void examine_tiff(const FileBytes& file, Examined& found);
void examine_psd(const FileBytes& file, Examined& found);
void examine_targa(const FileBytes& file, Examined& found);
void examine_dds(const FileBytes& file, Examined& found);
void examine_bmp(const FileBytes& file, Examined& found);
void examine_webp(const FileBytes& file, Examined& found);
void examine_heif(const FileBytes& file, Examined& found);
void examine_jpeg2000(const FileBytes& file, Examined& found);

// Of a TIFF structure as EXIF has it; 0 where it says nothing.
int exif_orientation(std::string_view exif);

}  // namespace nacre
