#include "app/designer/private_json_file.h"

#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/json_text.h"
#include "core/base/system/atomic_file.h"
#include "core/base/system/private_folder.h"

namespace nacre {

namespace fs = std::filesystem;

void read_object(const std::string& text, const std::string& name,
                 const std::function<void(ObjectReader&)>& take) {
    const JsonTree tree = parse_json(text, name);
    ObjectReader object(JsonValue(tree.root(), fs::path(name).stem().string(), name));
    take(object);
}

void PrivateJsonFile::read(
    const std::function<void(const std::string& text, const std::string& name)>& take) {
    std::error_code error;
    if (file_.empty() || !fs::exists(fs::symlink_status(file_, error))) return;
    try {
        take(read_text_file(file_), file_.string());
    } catch (const UserError& refused) {
        set_aside(refused.what());
    }
}

// The first free name of settings.json.damaged-1, -2, ...
void PrivateJsonFile::set_aside(const std::string& why) {
    untouchable_ = true;
    problem_ = why;
    for (int number = 1; number < 1000; ++number) {
        const fs::path aside = file_.string() + ".damaged-" + std::to_string(number);
        if (rename_if_free(file_, aside)) {
            untouchable_ = false;
            problem_ += "; it is kept as " + aside.filename().string() + ", and the defaults hold";
            return;
        }
        std::error_code error;
        if (!fs::exists(fs::symlink_status(aside, error))) break;
    }
    problem_ += "; the defaults apply, and the file is left as it is";
}

void PrivateJsonFile::write(const std::string& text) {
    if (file_.empty() || untouchable_) return;
    try {
        make_private_folder(file_.parent_path());
        write_file_atomically(file_, text);
        problem_.clear();
    } catch (const std::exception&) {
        problem_ = problem_line();
    }
}

std::optional<std::string> json_path(const fs::path& path) {
    try {
        return nlohmann::json(path.string()).dump();
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

fs::path read_path(const JsonValue& json) {
    std::string text = json.text();
    if (text.find('\0') != text.npos) json.fail("must be a path, which has no NUL");
    return text;
}

}  // namespace nacre
