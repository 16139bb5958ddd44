#include "app/cli/design_input.h"

#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/standard_input.h"
#include "core/design/design_file.h"
#include "core/design/picture_files.h"

namespace nacre::cli {

namespace fs = std::filesystem;

std::string name_of_input(const fs::path& file) {
    return file == stream_name ? standard_input : file.string();
}

Design read_design(const fs::path& file) {
    if (file != stream_name) return load_design(file);
    return parse_design(read_standard_input(), standard_input, {});
}

std::vector<fs::path> files_of(const Design& design, const fs::path& file) {
    std::vector<fs::path> files = picture_files(design);
    const std::vector<fs::path> sources = source_files(design);
    files.insert(files.end(), sources.begin(), sources.end());
    files.insert(files.begin(), file == stream_name ? "/dev/stdin" : file);
    return files;
}

std::shared_ptr<const Tables> bake_design(const Design& design, const fs::path& file,
                                          const BakeOptions& options, const Interrupt& interrupt) {
    Progress progress("baking");
    return about_file(file, [&] {
        return bake(design, options, interrupt.token(), [&](double done) { progress.report(done); });
    });
}

}  // namespace nacre::cli
