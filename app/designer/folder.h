// Folders as the designer's dialogs and its preset list show them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/dialogs.h"

namespace nacre {

// Folders and files whose name ends so, sorted, without hidden ones.
ui::Listing list_folder(const std::filesystem::path& folder, const std::string& ending);
ui::Listing list_designs(const std::filesystem::path& folder);

// The same with files of any of these endings, in small letters, in place of designs.
ui::Listing list_files(const std::filesystem::path& folder, const std::vector<std::string>& endings);

struct Preset {
    std::string name;  // of the file, without ".nacre"
    std::filesystem::path file;
};

std::vector<Preset> list_presets(const std::filesystem::path& folder);

// Beside the program: in the source tree it was built from, or below share/ where it was installed.
std::filesystem::path presets_folder();

}  // namespace nacre
