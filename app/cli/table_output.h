// Bakes a design with its albedo, measures the tables and writes them.
#pragma once

#include <filesystem>

#include "app/cli/interrupt.h"
#include "core/bake/tables.h"
#include "core/measure/table_error.h"

namespace nacre::cli {

struct WrittenTables {
    std::shared_ptr<const Tables> tables;
    TableErrors errors;
};

// threads = 0: as many as the machine has.
WrittenTables write_tables(const std::filesystem::path& design, const std::filesystem::path& folder,
                           int threads, Interrupt& interrupt);

}  // namespace nacre::cli
