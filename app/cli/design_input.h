// The design that a verb works on.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/bake/bake.h"
#include "core/base/error.h"
#include "core/base/system/interrupt.h"
#include "core/design/design.h"

namespace nacre::cli {

// What errors call it: "-" is standard input.
std::string name_of_input(const std::filesystem::path& file);

// A UserError of `work` that names no file is about `file`.
template <class Work>
auto about_file(const std::filesystem::path& file, const Work& work) {
    try {
        return work();
    } catch (const UserError& error) {
        if (!error.file.empty()) throw;
        throw UserError(name_of_input(file), error.where, error.problem, error.found);
    }
}

// As load_design(); "-" is standard input, and its pictures are then looked for in the current folder.
Design read_design(const std::filesystem::path& file);

// Every file that the design of `file` is read from.
std::vector<std::filesystem::path> files_of(const Design& design, const std::filesystem::path& file);

// Bakes with progress and Ctrl+C; `file` is what its errors name.
std::shared_ptr<const Tables> bake_design(const Design& design, const std::filesystem::path& file,
                                          const BakeOptions& options, const Interrupt& interrupt);

}  // namespace nacre::cli
