#include "app/designer/image_import.h"

#include <exception>
#include <utility>

#include "app/designer/picture_notes.h"
#include "core/base/error.h"
#include "core/image/picture.h"
#include "core/paint/layer_paint.h"
#include "core/paint/normal_map.h"
#include "core/paint/painted_layer.h"
#include "ui/dialogs.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

enum Answer { stamp, normals, heights, modulate, environment, cancel };

void add_layer_of(const std::vector<dvec3>& normals_found, double width, const std::string& name,
                  Distribution& distribution, std::size_t& chosen) {
    auto raster = raster_of_normals(normals_found, width);
    if (distribution.layers.size() >= limits::layers_max)
        throw UserError("", "layers", "a design holds no more layers", std::to_string(limits::layers_max));
    add_painted_layer(distribution, chosen);
    Layer& layer = distribution.layers[chosen];
    layer.name = name;
    const double others = weight_of_others(distribution, chosen);
    set_raster(layer, std::move(raster), 0, others > 0 ? others : 1);
}

void reading_fields(ReliefReading& reading) {
    const ReliefReading usual;
    ui::slider(
        {.label = "Smoothing",
         .low = 0,
         .high = 10,
         .least = 0,
         .most = 30,
         .reset = usual.smoothing,
         .format = "%.2f\u00b0",
         .logarithmic = false,
         .tooltip = "For normals and heights: how far each normal is spread, as the standard deviation of "
                    "its angle. 0 leaves them as they are."},
        reading.smoothing);
    ui::slider(
        {.label = "Height",
         .low = 0,
         .high = 20,
         .least = -1000,
         .most = 1000,
         .reset = usual.height,
         .format = "%.2f %% of the width",
         .logarithmic = false,
         .tooltip = "For heights: from black to white. Higher is rougher; a negative number makes black "
                    "the highest."},
        reading.height);
}

}  // namespace

void ImageImport::use(int answer, Distribution& distribution, std::size_t& chosen) {
    const std::filesystem::path file = *std::exchange(file_, std::nullopt);
    const std::string name = file.stem().string();
    PictureNotes notes;
    try {
        if (answer == stamp) {
            stamp_ = file;
        } else if (answer == normals) {
            add_layer_of(normals_of_map(normals_.picture(), normals_.reading()), reading_.smoothing, name,
                         distribution, chosen);
            notes = normals_.notes();
        } else if (answer == heights) {
            add_layer_of(normals_of_heights(normals_.picture(), reading_.height / 100), reading_.smoothing,
                         name, distribution, chosen);
            notes = normals_.picture_notes();
        } else if (answer == modulate && chosen < distribution.layers.size()) {
            auto raster = std::make_shared<const Raster>(
                load_picture(file, file.string(), "modulation", PictureShape::any, &notes));
            distribution.layers[chosen].modulation = Modulation{{{}, std::move(raster), notes}, 1};
        } else if (answer == environment) {
            environment_ = file;
        }
        if (!notes.empty()) note_ = notes_line(file, notes);
    } catch (const std::exception&) {
        problem_ = problem_line();
    }
    normals_.forget_picture();
}

void ImageImport::draw(Distribution& distribution, std::size_t& chosen) {
    if (!problem_.empty()) {
        if (ui::question("Cannot import the image", problem_, {"OK"})) problem_.clear();
        return;
    }
    if (!file_) return;
    const std::string text =
        "What is \u201c" + file_->filename().string() +
        "\u201d? A stamp paints through it. A map of normals or of heights becomes a "
        "layer with the facets of "
        "that surface. Modulation multiplies the chosen layer by it. A stamp or a "
        "modulation that is not square "
        "keeps its shape: black is added beside it. An environment map lights the object.";
    const auto answer =
        ui::question("Import image", text,
                     {"Stamp", "Normals", "Heights", "Modulation", "Environment map", "Cancel"}, [this] {
                         reading_fields(reading_);
                         normals_.draw();
                     });
    if (answer) use(*answer, distribution, chosen);
}

}  // namespace nacre
