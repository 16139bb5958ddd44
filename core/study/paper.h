// The figures of the paper and the numbers of its text, made again beside what it says of them
// (Ashikhmin, Premoze and Shirley 2000).
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/bake/baker.h"
#include "core/compare/comparison_model.h"

namespace nacre {

// What a picture shows a surface on, and how. Angles in degrees, as the preview has them.
struct PaperView {
    const char* object = "sphere";
    double theta = 42, phi = 125;  // of the light: from the viewer, from right toward up
    double pitch = 0;              // tilts the object's axis toward the viewer
    double zoom = 1;
    double exposure = 0;  // EV
    double yaw = 0;       // turns the object about its axis
};

// sRGB in [0, 1], three floats a pixel, top row first.
struct PaperImage {
    glm::ivec2 size{0};
    std::vector<float> rgb;
};

// This room knows no renderer: who asks for the paper brings one.
class PaperRenderer {
  public:
    virtual ~PaperRenderer() = default;
    virtual PaperImage draw(const ComparedSurface& surface, const PaperView& view, glm::ivec2 size) = 0;
    virtual float shown(double radiance) const = 0;  // by its display transform, sRGB in [0, 1]
};

struct PaperTools {
    PaperRenderer& renderer;
    Baker& baker;     // designs that differ in colour share their tables
    glm::ivec2 size;  // of each picture
    std::stop_token stop;
};

struct PaperPicture {
    std::string file;  // its name beside the page
    std::string caption;
    std::string bytes;
};

struct PaperTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

struct PaperResult {
    std::vector<PaperPicture> pictures;
    std::vector<PaperTable> tables = {};
    std::vector<std::string> remarks = {};  // what differs and why, a paragraph each
};

// A figure or a number: one file for each, core/study/paper/NAME.cpp, and its line in paper_list.inc.
struct PaperPart {
    const char* name;   // on the command line, and before the names of its files
    const char* title;  // "Figure 5: ..."
    const char* where;  // in the paper
    const char* says;   // its own words
    // Throws what bake() throws; BakeCancelled soon after a stop is requested.
    PaperResult (*make)(const PaperTools& tools);
};

std::span<const PaperPart* const> paper_parts();

#define PART(name) extern const PaperPart name##_part;
#include "core/study/paper_list.inc"
#undef PART

}  // namespace nacre
