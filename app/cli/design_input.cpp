#include "app/cli/design_input.h"

#include "app/cli/progress.h"

namespace nacre::cli {

std::shared_ptr<const Tables> bake_design(const Design& design, const std::filesystem::path& file,
                                          const BakeOptions& options, const Interrupt& interrupt) {
    Progress progress("baking");
    return about_file(file, [&] {
        return bake(design, options, interrupt.token(), [&](double done) { progress.report(done); });
    });
}

}  // namespace nacre::cli
