#include "app/designer/document.h"

#include <cctype>
#include <utility>

#include "core/base/input_file.h"
#include "core/design/design_file.h"
#include "core/design/picture_files.h"

namespace nacre {

Design starter_design() {
    Design design;
    design.distribution.layers[0].lobe = GaussianLobe{0.15, 0.15};
    design.diffuse = CoupledDiffuse{glm::dvec3(0.45, 0.06, 0.05)};
    return design;
}

Document::Document(Design start, std::filesystem::path from)
    : history(start), design(std::move(start)), file(std::move(from)) {
    history.mark_saved();
}

void Document::reload(const Document& read) {
    commit();
    design = read.design;
    held = read.held;
    commit();
    history.mark_saved();
}

void Document::commit() { history.commit(design); }

void Document::undo() {
    commit();
    history.undo();
    design = history.current();
}

void Document::redo() {
    commit();
    history.redo();
    design = history.current();
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
