// Folders as the designer's dialogs and its preset list show them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/dialogs.h"

namespace nacre {

inline constexpr const char* design_extension = ".nacre";

// Folders and files with one of these lower-case extensions (with any, where none is given),
// sorted, without hidden ones.
ui::Listing list_folder(const std::filesystem::path& folder,
                        const std::vector<std::string>& extensions = {design_extension});

// Whether the file has one of these lower-case extensions, ignoring case; they may be longer than a suffix:
// "_rgb.bsdf".
bool has_extension(const std::filesystem::path& file, const std::vector<std::string>& extensions);

struct Preset {
    std::string name;  // of the file, without ".nacre"
    std::filesystem::path file;
    bool is_start = false;  // a highlight to start from, more than a material
};

std::vector<Preset> list_presets(const std::filesystem::path& folder);

// The nearest folder above that exists; empty where none does.
std::filesystem::path existing_folder(std::filesystem::path folder);

// Seen from the program: below share/ where it is installed, else in the source tree it was built from.
std::filesystem::path presets_folder();

}  // namespace nacre
