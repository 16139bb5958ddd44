// Bakes a design with its albedo, measures the tables and writes them.
#pragma once

#include <filesystem>

#include "core/bake/bake.h"
#include "core/base/system/interrupt.h"
#include "core/verify/table_error.h"

namespace nacre::cli {

struct WrittenTables {
    std::shared_ptr<const Tables> tables;
    TableErrors errors;
};

// R is always baked.
WrittenTables write_tables(const std::filesystem::path& design, const std::filesystem::path& folder,
                           BakeOptions options, Interrupt& interrupt);

}  // namespace nacre::cli
