// The design that a verb works on.
#pragma once

#include <filesystem>
#include <memory>

#include "app/cli/interrupt.h"
#include "core/bake/bake.h"
#include "core/design/design.h"
#include "core/design/error.h"

namespace nacre::cli {

// A UserError of `work` that names no file is about `file`.
template <class Work>
auto about_file(const std::filesystem::path& file, const Work& work) {
    try {
        return work();
    } catch (const UserError& error) {
        if (!error.file.empty()) throw;
        throw UserError(file.string(), error.where, error.problem, error.found);
    }
}

// Bakes with progress and Ctrl+C; `file` is what its errors name.
std::shared_ptr<const Tables> bake_design(const Design& design, const std::filesystem::path& file,
                                          const BakeOptions& options, const Interrupt& interrupt);

}  // namespace nacre::cli
