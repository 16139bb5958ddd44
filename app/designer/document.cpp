#include "app/designer/document.h"

#include <atomic>
#include <cctype>
#include <utility>

#include "core/base/input_file.h"
#include "core/design/design_file.h"
#include "core/design/picture_files.h"

namespace nacre {
namespace {

std::atomic<std::uint64_t> documents = 0;  // so far

}  // namespace

Design starter_design() {
    Design design;
    design.distribution.layers[0].lobe = GaussianLobe{0.15, 0.15};
    design.diffuse = CoupledDiffuse{glm::dvec3(0.45, 0.06, 0.05)};
    return design;
}

Document::Document(Design start, std::filesystem::path from, const std::string& what)
    : history(start, !what.empty()  ? what
                     : from.empty() ? "New design"
                                    : "Open " + from.filename().string()),
      design(std::move(start)),
      file(std::move(from)),
      serial_(++documents) {
    history.mark_saved();
}

void Document::reload(const Document& read) {
    commit();
    doing = "Reload";
    design = read.design;
    held = read.held;
    commit();
    history.mark_saved();
}

void Document::keep_mine(const std::optional<FileContent>& now) {
    if (now)
        held[file] = *now;
    else
        held.erase(file);
    mark_unsaved();
}

void Document::commit() { history.commit(design, doing); }

void Document::begin(const Document& other, const std::string& what) {
    commit();
    origins_[history.document()] = {file, preset, held};
    history.begin(other.design, what);
    design = other.design;
    file = other.file;
    preset = other.preset;
    held = other.held;
}

// Where undo or redo has come to another document than it was.
void Document::follow_history(int before) {
    design = history.current();
    if (history.document() == before) return;
    origins_[before] = {std::move(file), std::move(preset), std::move(held)};
    Origin& origin = origins_.at(history.document());
    file = std::move(origin.file);
    preset = std::move(origin.preset);
    held = std::move(origin.held);
}

void Document::undo() {
    commit();
    const int before = history.document();
    history.undo();
    follow_history(before);
}

void Document::redo() {
    commit();
    const int before = history.document();
    history.redo();
    follow_history(before);
}

void Document::go_to(std::uint64_t number) {
    commit();
    const int before = history.document();
    history.go_to(number);
    follow_history(before);
}

std::vector<Document::Unsaved> Document::unsaved_elsewhere() const {
    std::vector<Unsaved> all;
    for (const History::State* state : history.unsaved_elsewhere()) {
        const Origin& origin = origins_.at(state->document);
        all.push_back({state->document, &state->design, origin.file, origin.held});
    }
    return all;
}

std::vector<Document::Unsaved> Document::all_unsaved() const {
    std::vector<Unsaved> all = unsaved_elsewhere();
    if (!history.saved()) all.insert(all.begin(), {history.document(), &history.current(), file, held});
    return all;
}

void Document::go_elsewhere() {
    commit();
    const auto others = history.unsaved_elsewhere();
    if (others.empty()) return;
    const int wanted = others.front()->document;
    while (history.document() != wanted && history.can_redo()) redo();
    while (history.document() != wanted && history.can_undo()) undo();
}

std::string Document::stem() const {
    if (!file.empty()) return file.stem().string();
    std::string text;
    for (const char c : design.name) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) != 0)
            text += static_cast<char>(std::tolower(letter));
        else if (!text.empty() && text.back() != '-')
            text += '-';
    }
    while (text.ends_with('-')) text.pop_back();
    return text.empty() ? "untitled" : text;
}

std::string Document::title() const {
    std::string text = file.filename().string();
    if (!design.name.empty())
        text = text.empty() ? design.name : design.name + " \u2013 " + text;
    else if (text.empty())
        text = "Untitled";
    return (unsaved() ? "\u25cf " : "") + text;
}

Document read_document(const std::filesystem::path& file) {
    const std::string text = read_text_file(file);
    Document document(parse_work(text, file.string(), file.parent_path()), file);
    document.held = held_now(picture_files(document.design));
    document.held[file] = content_of(text);
    return document;
}

}  // namespace nacre
