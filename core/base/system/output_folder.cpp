#include "core/base/system/output_folder.h"

#include <unistd.h>

#include <system_error>

#include "core/base/error.h"

namespace nacre {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const fs::path& folder) {
    std::error_code error;
    for (fs::path missing = folder; !missing.empty() && !fs::exists(missing, error) && !error;
         missing = missing.parent_path())
        made_.push_back(missing);
    if (!error) fs::create_directories(folder, error);
    const bool is_there = !error && fs::is_directory(folder, error);
    if (is_there) return;
    remove_empty();
    throw UserError(folder.string(), "write", "the folder cannot be made",
                    error ? error.message() : "it is no folder");
}

OutputFolder::~OutputFolder() { remove_empty(); }

void OutputFolder::remove_empty() const {
    for (const fs::path& folder : made_) ::rmdir(folder.c_str());
}

}  // namespace nacre
