// Two designs and what the designer exports of them: the same names, other bytes.
#pragma once

#include <filesystem>

#include "core/design/design.h"
#include "core/formats/export_format.h"

namespace nacre::test {

class Exports {
  public:
    Exports() {
        for (int which = 0; which < 2; ++which) {
            Design design;
            design.name = which == 0 ? "first" : "second";
            design.distribution.layers[0].lobe = BeckmannLobe{0.2 + 0.2 * which, 0.2 + 0.2 * which};
            for (const ExportFormat* format : quick_formats())
                writers_[which].push_back(format->prepare(design, {.bake = {.threads = 1}}, {}, {}));
        }
    }

    // A file or a folder of each format.
    void write(int which, const std::filesystem::path& folder) const {
        std::size_t index = 0;
        for (const ExportFormat* format : quick_formats())
            writers_[which][index++](folder /
                                     ("out-" + std::string(format->name) + std::string(format->extension)));
    }

  private:
    // Without MERL's, whose 35 MB would leave no time for the others.
    static std::vector<const ExportFormat*> quick_formats() {
        std::vector<const ExportFormat*> formats;
        for (const ExportFormat* format : export_formats())
            if (format->extension != merl_format.extension) formats.push_back(format);
        return formats;
    }

    std::vector<ExportWriter> writers_[2];
};

}  // namespace nacre::test
