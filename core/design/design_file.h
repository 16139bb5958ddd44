// The design file, NAME.nacre: JSON that holds all of the work. docs/file-format.md describes its keys.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/system/file_content.h"
#include "core/design/design.h"

namespace nacre {

inline constexpr int design_version = 2;  // the highest that is known

// The lowest version of the format that has every key this design needs.
int version_of(const Design& design);

// Whatever is wrong with the file or with a picture it names is a UserError.
Design load_design(const std::filesystem::path& file);

// Pictures are looked for relative to `base_dir`.
Design parse_design(std::string_view json_text, const std::string& file_name_for_errors,
                    const std::filesystem::path& base_dir);

// The same for unsaved work, which may hold no facets.
Design load_work(const std::filesystem::path& file);
Design parse_work(std::string_view json_text, const std::string& file_name_for_errors,
                  const std::filesystem::path& base_dir);

// Picture files are named relative to `base_dir`. Parsed again, the text gives an equal design; keys
// that the chosen models do not have (the correlation width of `uncorrelated`) are not in it.
std::string design_json(const Design& design, const std::filesystem::path& base_dir);

// The same with absolute paths, so that the text may be read anywhere on this machine.
std::string portable_design_json(const Design& design);

// The file appears whole or not at all. Returns its content.
FileContent save_design(const Design& design, const std::filesystem::path& file);

}  // namespace nacre
