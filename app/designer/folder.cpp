#include "app/designer/folder.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>
#include <tuple>

namespace nacre {
namespace {

namespace fs = std::filesystem;

bool is_vowel(char letter) { return std::string_view("aeiouy").find(letter) != std::string_view::npos; }

// "brushed-gold" reads as "Brushed gold"; a word without a vowel is an abbreviation: "GGX steel".
std::string spoken(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '_' || c == '-'; }, ' ');
    const auto upper = [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); };
    for (auto word = name.begin(); word != name.end();) {
        const auto end = std::find(word, name.end(), ' ');
        if (std::none_of(word, end, is_vowel)) std::transform(word, end, word, upper);
        word = end == name.end() ? end : end + 1;
    }
    if (!name.empty()) name[0] = upper(name[0]);
    return name;
}

}  // namespace

ui::Listing list_designs(const fs::path& folder) { return list_folder(folder, ".nacre"); }

ui::Listing list_folder(const fs::path& folder, const std::string& ending) {
    return list_files(folder, {ending});
}

ui::Listing list_files(const fs::path& folder, const std::vector<std::string>& endings) {
    ui::Listing listing;
    std::error_code error;
    listing.directory = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
    if (!listing.directory.has_filename() && listing.directory.has_relative_path())
        listing.directory = listing.directory.parent_path();
    for (auto it = fs::directory_iterator(listing.directory, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
        const std::string name = it->path().filename().string();
        std::error_code unreadable;
        const bool is_directory = it->is_directory(unreadable);
        if (unreadable || name.starts_with('.')) continue;
        std::string ending = it->path().extension().string();
        std::transform(ending.begin(), ending.end(), ending.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (is_directory || std::find(endings.begin(), endings.end(), ending) != endings.end())
            listing.entries.push_back({name, is_directory});
    }
    if (error) listing.problem = error.message();
    std::sort(listing.entries.begin(), listing.entries.end(), [](const auto& a, const auto& b) {
        return std::tuple(!a.is_directory, a.name) < std::tuple(!b.is_directory, b.name);
    });
    return listing;
}

std::vector<Preset> list_presets(const fs::path& folder) {
    std::vector<Preset> presets;
    const ui::Listing listing = list_designs(folder);
    for (const auto& entry : listing.entries)
        if (!entry.is_directory) {
            const fs::path file = listing.directory / entry.name;
            presets.push_back({spoken(file.stem().string()), file});
        }
    return presets;
}

fs::path presets_folder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const char* candidate : {"../../presets", "../share/nacre/presets"})
        if (fs::is_directory(program / candidate, error)) return (program / candidate).lexically_normal();
    return {};
}

}  // namespace nacre
