#include "app/cli/verbs.h"

namespace nacre::cli {

std::span<const Verb> verbs() {
    static constexpr Verb list[] = {
        {"info", "what a design is, what it needs and what it can do without", declare_info},
        {"eval", "the BRDF of pairs of directions read from standard input", declare_eval},
        {"tables", "g, P, R0 and R1 of directions read from standard input", declare_tables},
        {"bake", "bake a design and write its tables with their manifest", declare_bake},
        {"render", "the design on an object, as a picture", declare_render},
        {"plot", "R, P, p, F, the lobe or the slice of a design, as SVG or CSV", declare_plot},
        {"screenshot", "the designer's window, as a picture", declare_screenshot},
        {"check",
         "the physics of a design and the errors that its bake claims; exit code 1 when a check fails",
         declare_check},
        {"report", "error against run time of each way of computing g and R", declare_report},
        {"export", "a design in another program's format", declare_export},
        {"import", "a design from another program's file; not in this version", declare_unarrived},
        {"gallery", "every design of a folder rendered, with a contact sheet", declare_gallery},
    };
    return list;
}

}  // namespace nacre::cli
