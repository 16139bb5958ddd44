// The words beside the tables: everything that a stranger needs to evaluate them.
#pragma once

#include <string>
#include <vector>

#include "core/formats/table_files.h"

namespace nacre {

// JSON text.
std::string table_manifest(const Design& design, const Tables& tables,
                           const std::vector<TablePicture>& pictures, const TableErrors& errors);

// The file of a layer's picture; `layer` counts the layers in use from 0.
std::string layer_picture_file(int layer, const std::string& kind);

}  // namespace nacre
