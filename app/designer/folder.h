// Folders as the designer's dialogs and its preset list show them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/dialogs.h"

namespace nacre {

inline constexpr const char* design_extension = ".nacre";

// Folders and files with the extension (any, where it is empty), sorted, without hidden ones.
ui::Listing list_folder(const std::filesystem::path& folder, const std::string& extension = design_extension);

struct Preset {
    std::string name;  // of the file, without ".nacre"
    std::filesystem::path file;
};

std::vector<Preset> list_presets(const std::filesystem::path& folder);

// The nearest folder above that exists; empty where none does.
std::filesystem::path existing_folder(std::filesystem::path folder);

// Beside the program: in the source tree it was built from, or below share/ where it was installed.
std::filesystem::path presets_folder();

}  // namespace nacre
