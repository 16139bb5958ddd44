#include "app/designer/command.h"

namespace nacre {

const Command export_design_command{
    .info = {.menu = "File",
             .label = "Export\u2026",
             .keys = "Ctrl+E",
             .about = "Write tables, a GLSL function or a picture for other programs."},
    .perform = [](Designer& designer, std::size_t) { designer.exporter.start(); }};

}  // namespace nacre
