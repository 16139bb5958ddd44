// The baked tables as EXR files with a JSON manifest that says how to evaluate them.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/bake/tables.h"
#include "core/design/design.h"
#include "core/verify/table_error.h"

namespace nacre {

// One table as a picture: columns along x, rows along y, the first scan line is row 0.
struct TablePicture {
    std::string file;
    std::string quantity;  // what a texel holds
    std::string x;         // the variable along a scan line; empty where there is but one texel of it
    std::string y;         // the variable from scan line to scan line
    glm::ivec2 size{0};
    std::vector<std::string> channels;  // Y, or R, G, B
    std::vector<float> values;
};

std::vector<TablePicture> table_pictures(const Tables& tables);

// Every file that write_table_files() may write there.
std::vector<std::filesystem::path> table_files(const std::filesystem::path& folder, const Design& design);

// Writes every picture and then manifest.json into `folder`, which is made when it is not there. Returns the
// files.
std::vector<std::filesystem::path> write_table_files(const std::filesystem::path& folder,
                                                     const Design& design, const Tables& tables,
                                                     const TableErrors& errors);

}  // namespace nacre
