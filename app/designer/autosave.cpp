#include "app/designer/autosave.h"

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "app/designer/kept_file.h"
#include "core/design/design_file.h"
#include "core/design/error.h"
#include "core/design/json_text.h"
#include "core/exchange/atomic_file.h"
#include "core/exchange/input_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr int version = 1;

std::string head_text(const UnsavedWork& work) {
    nlohmann::ordered_json head;
    head["nacre_autosave"] = version;
    head["name"] = work.design.name;
    if (json_path(work.file)) head["file"] = work.file.string();
    return head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

AutosaveHead head_of(std::string_view line, const std::string& file) {
    const nlohmann::json json = parse_json(line, file);
    ObjectReader object(JsonValue(json, "unsaved", file));
    object.required("nacre_autosave", "the version of the file").whole_number(version, version);
    AutosaveHead head;
    std::string path;
    object.text("name", head.name);
    object.text("file", path);
    object.finish("unsaved work");
    head.file = path;
    return head;
}

}  // namespace

void write_autosave(const UnsavedWork& work, const fs::path& file) {
    write_file_atomically(file, head_text(work) + design_json(work.design, file.parent_path()));
}

AutosaveHead read_autosave_head(const fs::path& file) {
    const std::string line = read_first_line(file);
    return head_of(line, file.string());
}

UnsavedWork read_autosave(const fs::path& file) {
    const std::string text = read_text_file(file);
    const std::size_t end = std::min(text.find('\n'), text.size());
    const AutosaveHead head = head_of(std::string_view(text).substr(0, end), file.string());
    return {parse_work(std::string_view(text).substr(end), file.string(), file.parent_path()), head.file};
}

Autosave::Autosave(fs::path folder)
    : folder_(std::move(folder)),
      job_([this](const Wanted& wanted, const std::stop_token&, const auto& publish) {
          write(wanted);
          publish(true);
      }) {}

void Autosave::write(const Wanted& wanted) {
    if (!wanted) {
        if (own_) own_->remove(autosave_name);
        return;
    }
    if (!own_) own_ = make_owned_folder(folder_);
    write_autosave(*wanted, own_->path() / autosave_name);
}

void Autosave::submit(Wanted wanted) {
    wanted_ = std::move(wanted);
    asked_ = job_.submit(wanted_);
}

void Autosave::follow(const Document& document) {
    if (folder_.empty()) return;
    if (const auto done = job_.poll()) {
        kept_ = done->revision;
        problem_ = done->error ? plain_words(done->error) : std::string();
    }
    const Design& newest = document.history.current();
    if (document.history.saved()) {
        if (wanted_) submit({});
    } else if (!wanted_ || wanted_->design != newest || wanted_->file != document.file) {
        submit(UnsavedWork{newest, document.file});
    }
}

void Autosave::take_over(LostAndFound found) {
    if (folder_.empty()) return;
    job_.wait();
    if (!own_) own_ = make_owned_folder(folder_);
    own_->take(autosave_name, found.folder);
    wanted_ = std::move(found.work);
    found.folder.erase();
}

void Autosave::finish() {
    job_.wait();
    if (own_) own_->erase();
    own_.reset();
}

}  // namespace nacre
