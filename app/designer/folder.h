// Folders as the designer's dialogs and its preset list show them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/dialogs.h"

namespace nacre {

inline constexpr const char* design_extension = ".nacre";

// Folders and files of any of these endings, in small letters (of any at all, where there are none), sorted,
// without hidden ones.
ui::Listing list_folder(const std::filesystem::path& folder,
                        const std::vector<std::string>& endings = {design_extension});

// Whether the name ends in any of these, given in small letters, be it in small letters or in capitals.
bool has_ending(const std::filesystem::path& file, const std::vector<std::string>& endings);

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
