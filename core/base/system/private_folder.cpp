#include "core/base/system/private_folder.h"

#include <sys/stat.h>

#include <cerrno>

#include "core/base/error.h"
#include "core/base/system/system_call.h"

namespace nacre {

void make_private_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::is_directory(folder, error)) return;
    if (folder.has_parent_path() && folder.parent_path() != folder) make_private_folder(folder.parent_path());
    if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
        throw UserError(folder.string(), "write", "the folder cannot be made", system_reason(errno));
}

}  // namespace nacre
