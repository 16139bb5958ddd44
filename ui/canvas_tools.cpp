#include "ui/canvas_tools.h"

namespace nacre::ui {
namespace {

constexpr ToolEntry tools[] = {
    {CanvasTool::handles, "Handles", 'V', "Shapes lobes by their handles.",
     "The middle leans a lobe, its ends widen it, its outline turns it."},
    {CanvasTool::grab, "Grab", 'G', "Carries a highlight along, here or on the object.",
     "Of the layer that is strongest there a painted hill follows up to the valleys about it, a lobe as a "
     "whole."},
    {CanvasTool::paint, "Paint", 'B', "Adds facets, here or on the object.",
     "Facets that lean up shine below the highlight's middle, those that lean left to the right "
     "of it: on the object the brush paints where you see it. On a lobe that is not painted a new painted "
     "layer begins."},
    {CanvasTool::erase, "Erase", 'E', "Takes facets away.", "What is left keeps its ratios."},
    {CanvasTool::smooth, "Smooth", 'S', "Softens what is painted.", "Edges of the highlight blur."},
    {CanvasTool::smear, "Smear", 'M', "Pushes paint along.", "The highlight is drawn out like wet paint."},
    {CanvasTool::stamp, "Stamp", 'T', "Stamps a picture, as broad as the brush.",
     "White paints. A picture that is dropped on the window can become one."},
    {CanvasTool::line, "Line", 'L', "A line from press to release.", "As broad and as hard as the brush."},
    {CanvasTool::ring, "Ring", 'R', "A ring about the press: a halo.", "The drag gives its radius."},
    {CanvasTool::star, "Star", 'K', "Rays from the press that taper off: a sparkle.",
     "The drag gives their length."},
};

}  // namespace

std::span<const ToolEntry> canvas_tools() { return tools; }

std::string tool_tooltip(const ToolEntry& entry) {
    return std::string(entry.name) + " (" + entry.key + "). " + entry.about + " " + entry.more;
}

}  // namespace nacre::ui
