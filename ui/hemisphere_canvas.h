// The canvas: p(h) on the hemisphere of facet normals, with its grid, its colour scale and the cursor's
// numbers.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "core/model/facet_distribution.h"
#include "core/paint/brush_presets.h"
#include "core/paint/density_picture.h"
#include "core/paint/hemisphere_view.h"
#include "core/paint/highlight.h"
#include "core/paint/layer_paint.h"
#include "core/paint/lobe_handles.h"
#include "core/paint/select_tool.h"
#include "core/paint/selection.h"
#include "core/paint/stamps.h"
#include "core/paint/stroke.h"
#include "core/paint/transform.h"

namespace nacre::ui {

// A handle that is held, as it was when it was taken.
struct GrabbedHandle {
    HandleKind kind;
    std::size_t layer;
    dvec3 at;
    glm::dvec2 pixel;  // of the pointer
    Layer before;
    // Where an end is shown that would else lie on its axis: a drag scales by how far the pointer is from
    // there.
    std::optional<glm::dvec2> moved_apart;
};

// What the left button does: it pulls the handles of lobes, grabs highlights, paints, or selects.
enum class CanvasTool {
    handles,
    grab,
#define TOOL(name) name,
#include "core/paint/tool_list.inc"
#undef TOOL
#define SELECT(name) select_##name,
#include "core/paint/select_list.inc"
#undef SELECT
    transform
};

// Where a drag has begun and therefore stays.
enum class Surface { canvas, sphere };

// A layer that is carried along: a painted one by the highlight that was taken hold of, any other whole.
struct CarriedLayer {
    std::size_t layer;
    Layer before;
    dvec3 from;
    Surface surface;
    glm::dvec2 pixel;  // of the pointer when it was last followed
    std::optional<Highlight> highlight;
};

// A stroke while the button is held.
struct HeldBrush {
    LayerPaint paint;
    Stroke stroke;
    glm::dvec2 pixel;  // that the brush has reached
    dvec3 begin, end;  // normals of the press and there
    Surface surface;
    Touch touch = {};  // of the hand in the newest frame
    // Before the press, for a shape that is nothing until the pointer moves.
    std::optional<Distribution> origin = {};
    std::size_t chosen = 0;
};

// Shift is held: a drag sizes the brush, a click draws a line from where the last stroke ended.
struct SizedBrush {
    glm::dvec2 pixel;  // of the press
    double radius;     // before
    bool dragged = false;
    Surface surface;
};

// An area that is being marked.
struct HeldSelection {
    std::vector<glm::dvec2> way;  // of the pointer, pixels
    SelectMode mode;
};

// What a box of handles stands about.
struct TransformSubject {
    std::size_t layer = 0;
    LayerPart part = LayerPart::lobe;
    std::shared_ptr<const Raster> raster = {};  // null: nothing
    std::shared_ptr<const Selection> selection = {};
    glm::dmat3 frame{1};  // of the layer

    bool operator==(const TransformSubject&) const = default;
};

// Where a box is held.
struct TransformGrip {
    enum class Kind { move, pull, turn } kind;
    dvec2 handle;  // of the box, where it is pulled
    DiskBox before;
    dvec2 from;  // of the press, on the surface's disk
};

struct HeldTransform {
    TransformSubject subject;  // as it is shown
    Transform transform;
    DiskBox box;
    Blend blend = Blend::replace;
    std::optional<LayerPaint> paint = {};     // from the first drag on
    std::optional<Distribution> origin = {};  // before it
    std::optional<TransformGrip> grip = {};
};

struct StrokeEnd {
    std::size_t layer;
    dvec3 at;  // normal, in the surface's frame
};

// Why p could not be balanced.
struct Refusal {
    dvec3 mean;  // normal, of the p that it was
    std::string why;
};

// What the canvas remembers between frames; no part of the document.
struct CanvasState {
    HemisphereCamera camera;
    ScaleKind scale = ScaleKind::perceptual;
    CanvasTool tool = CanvasTool::handles;
    Brush brush;
    BrushSymmetry symmetry;
    int rays = usual_rays;
    GradientForm form = GradientForm::linear;
    double tolerance = usual_tolerance;
    std::vector<NamedStamp> stamps = built_in_stamps();
    std::size_t stamp = 0;
    StampPose pose;
    bool asks_for_stamp = false;  // a picture to stamp with is to be loaded; whoever does takes it back
    std::optional<GrabbedHandle> grabbed;
    std::optional<HeldBrush> held;
    std::optional<SizedBrush> sized;
    std::shared_ptr<const Selection> selection;  // that the tools keep to; null: all
    std::optional<HeldSelection> selecting;
    std::optional<HeldTransform> transform;
    bool paints_mask = false;  // where the chosen layer has one, the tools work on its mask
    std::optional<StrokeEnd> last_stroke;
    std::optional<double> pressure;  // of a pen, 0 to 1; none of a mouse
    double steadiness = 0;           // pixels that the brush hangs behind the pointer, as on a string
    std::vector<NamedBrush> own_brushes;
    std::string brush_name;  // as it is typed
    std::optional<CarriedLayer> carried;
    std::optional<Refusal> refusal;
};

// What the hand works on: p as it was shown when the hand moved.
struct CanvasSight {
    const FacetDistribution* p = nullptr;  // null for a design without facets
    std::optional<dvec3> mean;             // of the facets' normals, while all layers are shown
};

// Where the canvas lies in this frame, and what its pixels stand for.
struct CanvasFrame {
    ImVec2 low, high;  // left top, right bottom
    HemisphereView view;
    bool hovered = false;
    std::optional<dvec3> cursor;  // the normal under the pointer

    ImVec2 screen(dvec3 h) const;
    glm::dvec2 pixel(ImVec2 screen) const;  // as `view` counts
};

// What is shown on the canvas.
struct CanvasContents {
    const Distribution* design = nullptr;
    std::size_t chosen = 0;                // layer
    const FacetDistribution* p = nullptr;  // null for a design without facets
    ImTextureID picture = nullptr;         // null while there is none
    ImVec2 picture_size;  // of the canvas, from its left top corner, in the units of the interface
    DensityScale scale;
    std::optional<dvec3> mean;    // see CanvasSight
    std::optional<dvec3> marked;  // by the preview: the normal of the facets that light what is pointed at
};

// The buttons above the canvas. Fills the rest of the window but for the legend below it. The wheel and the
// middle and right buttons move the camera; the left one pulls handles of the layers or paints.
CanvasFrame begin_canvas(CanvasState& state, const CanvasSight& sight, Distribution& distribution,
                         std::size_t& chosen);

// Picture, grid, mean normal, handles or brush, and the legend below.
void end_canvas(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents);

}  // namespace nacre::ui
