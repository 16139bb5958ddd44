#include "app/designer/folder.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>
#include <tuple>

#include "core/base/system/shared_library.h"

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

ui::Listing list_folder(const fs::path& folder, const std::vector<std::string>& extensions) {
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
        if (is_directory || extensions.empty() || has_extension(it->path(), extensions))
            listing.entries.push_back({name, is_directory});
    }
    if (error) listing.problem = error.message();
    std::sort(listing.entries.begin(), listing.entries.end(), [](const auto& a, const auto& b) {
        return std::tuple(!a.is_directory, a.name) < std::tuple(!b.is_directory, b.name);
    });
    return listing;
}

bool has_extension(const fs::path& file, const std::vector<std::string>& extensions) {
    std::string name = file.filename().string();
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return std::any_of(extensions.begin(), extensions.end(), [&](const std::string& extension) {
        return name.size() > extension.size() && name.ends_with(extension);
    });
}

std::vector<Preset> list_presets(const fs::path& folder) {
    std::vector<Preset> presets;
    const ui::Listing listing = list_folder(folder);
    for (const auto& entry : listing.entries)
        if (!entry.is_directory) {
            const fs::path file = listing.directory / entry.name;
            presets.push_back({spoken(file.stem().string()), file});
        }
    return presets;
}

fs::path existing_folder(fs::path folder) {
    std::error_code error;
    while (!folder.empty() && !fs::is_directory(folder, error)) {
        const fs::path above = folder.parent_path();
        folder = above == folder ? fs::path() : above;
    }
    return folder;
}

fs::path presets_folder() {
    const fs::path program = program_folder();
    std::error_code error;
    for (const char* candidate : {"../share/nacre/presets", "../../presets"})
        if (fs::is_directory(program / candidate, error)) return (program / candidate).lexically_normal();
    return {};
}

}  // namespace nacre
