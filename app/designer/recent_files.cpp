#include "app/designer/recent_files.h"

#include <fmt/format.h>

#include <algorithm>

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr int version = 1;

std::vector<fs::path> read_files(ObjectReader& object) {
    object.required("nacre_recent", "the version of the list").whole_number(version, version);
    std::vector<fs::path> files;
    for (const JsonValue& file :
         object.required("files", "the files' paths").elements("must be a list of paths"))
        files.push_back(read_path(file));
    object.finish("the list of recent files");
    return files;
}

}  // namespace

std::vector<fs::path> parse_recent(const std::string& text, const std::string& name) {
    std::vector<fs::path> files;
    read_object(text, name, [&](ObjectReader& object) { files = read_files(object); });
    return files;
}

RecentFiles::RecentFiles(const fs::path& folder)
    : file_(folder.empty() ? fs::path() : folder / "recent.json") {
    read();
}

void RecentFiles::read() {
    file_.read(
        [this](const std::string& text, const std::string& name) { files_ = parse_recent(text, name); });
}

void RecentFiles::note(const fs::path& file) {
    read();
    std::erase(files_, file);
    files_.insert(files_.begin(), file);
    if (files_.size() > files_max) files_.resize(files_max);
    write();
}

void RecentFiles::forget(const fs::path& file) {
    read();
    std::erase(files_, file);
    write();
}

void RecentFiles::clear() {
    files_.clear();
    write();
}

void RecentFiles::write() {
    std::string list;
    for (const fs::path& file : files_)
        if (const auto json = json_path(file)) list += (list.empty() ? "\n    " : ",\n    ") + *json;
    file_.write(fmt::format("{{\n  \"nacre_recent\": {},\n  \"files\": [{}\n  ]\n}}\n", version, list));
}

}  // namespace nacre
