#include "app/designer/folder_opener.h"

#include "app/designer/program_in_path.h"

namespace nacre {

namespace fs = std::filesystem;

fs::path find_folder_opener(const EnvironmentVariables& environment) {
    return has_display(environment) ? program_in_path(environment, "xdg-open") : fs::path();
}

void FolderOpener::open(const fs::path& folder, const fs::path& program) {
    problem_.clear();
    folder_ = folder;
    process_.reset();
    if (program.empty())
        problem_ = "There is no program here that opens folders: xdg-open is not installed.";
    else
        process_.emplace(program, std::vector<std::string>{"xdg-open", folder.string()});
}

const std::string& FolderOpener::problem() {
    if (!process_) return problem_;
    const auto ended = process_->poll();
    if (!ended) return problem_;
    process_.reset();
    if (ended->code != 0) problem_ = "xdg-open could not open " + folder_.string() + ".";
    return problem_;
}

}  // namespace nacre
