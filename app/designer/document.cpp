#include "app/designer/document.h"

#include <utility>

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

std::string Document::title() const {
    const std::string name = design.name.empty() ? "Untitled" : design.name;
    const std::string where = file.empty() ? "" : " \u2013 " + file.filename().string();
    return (unsaved() ? "\u25cf " : "") + name + where;
}

}  // namespace nacre
