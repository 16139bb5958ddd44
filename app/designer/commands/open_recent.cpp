#include <filesystem>

#include "app/designer/command.h"

namespace nacre {
namespace {

std::vector<ui::CommandChoice> recent_files(const Designer& designer) {
    std::vector<ui::CommandChoice> choices;
    for (const std::filesystem::path& file : designer.recent.files())
        choices.push_back({file.filename().string(), file.string()});
    return choices;
}

void open_recent(Designer& designer, std::size_t which) {
    const auto& files = designer.recent.files();
    if (which >= files.size()) return;
    const std::filesystem::path file = files[which];  // opening it changes the list
    designer.files.open_file(designer.document, file);
}

}  // namespace

const Command open_recent_command{
    .info = {.menu = "File/Open recent", .label = "Recent", .keys = nullptr, .about = nullptr},
    .enabled = [](const Designer& designer) { return !designer.recent.files().empty(); },
    .choices = recent_files,
    .perform = open_recent};

}  // namespace nacre
