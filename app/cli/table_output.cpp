#include "app/cli/table_output.h"

#include "app/cli/design_input.h"
#include "core/base/system/output_guard.h"
#include "core/formats/table_files.h"

namespace nacre::cli {
WrittenTables write_tables(const std::filesystem::path& design, const std::filesystem::path& folder,
                           BakeOptions options, Interrupt& interrupt) {
    options.albedo = true;
    const Design loaded = read_design(design);
    check_outputs(table_files(folder, loaded), files_of(loaded, design));
    WrittenTables result;
    result.tables = bake_design(loaded, design, options, interrupt);
    result.errors = measure_table_errors(*result.tables, Reference(loaded), interrupt.token());
    interrupt.write_files([&] { write_table_files(folder, loaded, *result.tables, result.errors); });
    return result;
}

}  // namespace nacre::cli
