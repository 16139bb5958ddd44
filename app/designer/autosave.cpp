#include "app/designer/autosave.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "app/designer/private_json_file.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/json_text.h"
#include "core/base/system/atomic_file.h"
#include "core/design/design_file.h"
#include "core/design/design_pictures.h"
#include "core/design/picture_files.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr int version = 2;  // 1 named pictures by their files alone

// A file as JSON: its path, and what it held. Nothing for a path that is not UTF-8.
std::optional<nlohmann::ordered_json> file_json(const fs::path& file, const HeldFiles& held) {
    if (file.empty() || !json_path(file)) return {};
    nlohmann::ordered_json json;
    json["file"] = file.string();
    if (const auto content = content_in(held, file)) json["held"] = content_text(*content);
    return json;
}

std::string head_text(const UnsavedWork& work) {
    nlohmann::ordered_json head;
    head["nacre_autosave"] = version;
    head["name"] = work.design.name;
    if (const auto file = file_json(work.file, work.held)) head.update(*file);
    auto pictures = nlohmann::ordered_json::array();
    for_each_picture(work.design, [&](const Picture& picture, const std::string& where) {
        if (auto file = file_json(picture.file, work.held)) {
            (*file)["at"] = where;
            pictures.push_back(*std::move(file));
        }
    });
    if (!pictures.empty()) head["pictures"] = std::move(pictures);
    return head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

// The first line.
struct Head {
    std::string name;
    fs::path file;
    std::map<std::string, fs::path> pictures;  // by where they stand in the design
    HeldFiles held;
};

fs::path read_file(ObjectReader& object, HeldFiles& held) {
    if (!object.has("file")) return {};
    const fs::path file = read_path(object.at("file"));
    if (!file.is_absolute()) object.at("file").fail("must be an absolute path");
    if (!object.has("held")) return file;
    const auto content = parse_content(object.at("held").text());
    if (!content) object.at("held").fail("must tell what the file held");
    held[file] = *content;
    return file;
}

Head read_head(std::string_view line, const std::string& file) {
    const JsonTree tree = parse_json(line, file);
    ObjectReader object(JsonValue(tree.root(), "unsaved", file));
    object.required("nacre_autosave", "the version of the file").whole_number(1, version);
    Head head;
    object.text("name", head.name);
    head.file = read_file(object, head.held);
    if (object.has("pictures"))
        for (const JsonValue& element : object.at("pictures").elements("must be a list of pictures")) {
            ObjectReader picture(element);
            std::string at;
            picture.text("at", at);
            head.pictures[at] = read_file(picture, head.held);
            picture.finish("a picture's file");
        }
    object.finish("unsaved work");
    return head;
}

// What is known of the files that the work needs.
HeldFiles needed(const HeldFiles& known, const Design& design, const fs::path& own) {
    HeldFiles held;
    const auto hold = [&](const fs::path& file) {
        if (const auto content = content_in(known, file)) held[file] = *content;
    };
    hold(own);
    for (const fs::path& file : picture_files(design)) hold(file);
    return held;
}

}  // namespace

void write_autosave(const UnsavedWork& work, const fs::path& file, std::uintmax_t bytes_max) {
    std::string text =
        design_json(with_pictures_held(work.design, picture_files(work.design)), file.parent_path());
    text.insert(0, head_text(work));
    if (text.size() > bytes_max)
        throw UserError(file.string(), "write",
                        fmt::format("the work is larger than the {} bytes that can be restored", bytes_max),
                        fmt::format("{} bytes", text.size()));
    write_file_atomically(file, text);
}

AutosaveHead read_autosave_head(const fs::path& file) {
    Head head = read_head(read_first_line(file, autosave_bytes_max), file.string());
    return {std::move(head.name), std::move(head.file)};
}

UnsavedWork read_autosave(const fs::path& file) {
    return parse_autosave(read_text_file(file, autosave_bytes_max), file);
}

UnsavedWork parse_autosave(const std::string& text, const fs::path& file) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    Head head = read_head(std::string_view(text).substr(0, end), file.string());
    Design design = parse_work(std::string_view(text).substr(end), file.string(), file.parent_path());
    for_each_picture(design, [&](Picture& picture, const std::string& where) {
        if (const auto found = head.pictures.find(where); found != head.pictures.end())
            picture.file = found->second;
    });
    return {std::move(design), std::move(head.file), std::move(head.held)};
}

Autosave::Autosave(fs::path folder, std::uintmax_t bytes_max)
    : folder_(std::move(folder)),
      bytes_max_(bytes_max),
      job_([this](const std::vector<Wanted>& wanted, const std::stop_token&, const auto& publish) {
          write(wanted);
          publish(true);
      }) {}

// What is new is on the disk before anything is removed, and what cannot be written hinders no other work.
void Autosave::write(const std::vector<Wanted>& wanted) {
    std::exception_ptr error;
    for (const Wanted& one : wanted) {
        try {
            Place& place = place_of(one.document);
            if (place.number == one.number) continue;
            write_autosave(one.work, place.folder.file(), bytes_max_);
            place.number = one.number;
        } catch (const std::exception&) {
            if (!error) error = std::current_exception();
        }
    }
    clear_others(wanted);
    if (error) std::rethrow_exception(error);
}

// Its folder, one that has become free, or a new one; another one where somebody has changed what it is.
Autosave::Place& Autosave::place_of(int document) {
    auto found = std::ranges::find(places_, std::optional(document), &Place::document);
    if (found == places_.end()) found = std::ranges::find(places_, std::optional<int>(), &Place::document);
    if (found == places_.end())
        found = places_.insert(found, Place{make_locked_directory(folder_), document});
    if (!found->folder.intact()) *found = Place{make_locked_directory(folder_), document};
    found->document = document;
    return *found;
}

void Autosave::clear_others(const std::vector<Wanted>& wanted) {
    for (Place& place : places_) {
        if (!place.document) continue;
        if (std::ranges::find(wanted, *place.document, &Wanted::document) != wanted.end()) continue;
        place.folder.remove_file();
        place.document.reset();
        place.number = 0;
    }
}

void Autosave::follow(const Document& document) {
    if (folder_.empty()) return;
    if (const auto done = job_.poll()) {
        kept_ = done->revision;
        problem_ = done->error ? problem_line(done->error) : std::string();
    }
    std::vector<Document::Unsaved> unsaved = document.all_unsaved();
    bool changed = unsaved.size() != wanted_.size();
    std::vector<const Wanted*> before;  // of each work, where it is as it was
    for (Document::Unsaved& work : unsaved) {
        work.held = needed(work.held, *work.design, work.file);
        const auto same = std::ranges::find_if(wanted_, [&](const Wanted& wanted) {
            return wanted.document == work.document && wanted.work.design == *work.design &&
                   wanted.work.file == work.file && wanted.work.held == work.held;
        });
        before.push_back(same != wanted_.end() ? &*same : nullptr);
        changed |= before.back() == nullptr;
    }
    if (!changed) return;
    std::vector<Wanted> wanted;
    for (std::size_t i = 0; i < unsaved.size(); ++i) {
        const Document::Unsaved& work = unsaved[i];
        wanted.push_back(before[i] != nullptr
                             ? *before[i]
                             : Wanted{work.document, ++numbers_, {*work.design, work.file, work.held}});
    }
    wanted_ = std::move(wanted);
    asked_ = job_.submit(wanted_);
}

void Autosave::take_over(RecoveredWork found, int document) {
    if (folder_.empty()) return;
    job_.wait();
    try {
        Place& place = place_of(document);
        place.folder.take(found.folder);
        found.folder.erase();
        place.number = ++numbers_;
        std::erase_if(wanted_, [&](const Wanted& wanted) { return wanted.document == document; });
        wanted_.push_back({document, place.number, std::move(found.work)});
    } catch (const std::exception&) {
        problem_ = problem_line();  // it is written again, and what was left stays
    }
}

void Autosave::finish() {
    job_.wait();
    for (Place& place : places_) place.folder.erase();
    places_.clear();
}

}  // namespace nacre
