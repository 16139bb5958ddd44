#include "core/paint/source_raster.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"
#include "core/paint/stamps.h"
#include "core/paint/stroke.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr double draft_side = 256;  // pixels each way that a draft takes, about

std::uintmax_t size_of(const fs::path& file) {
    std::error_code error;
    return fs::file_size(file, error);
}

fs::file_time_type time_of(const fs::path& file) {
    std::error_code error;
    return fs::last_write_time(file, error);
}

StampPose pose_of(const PictureSource& source) { return {.angle = source.rotation, .flip = source.flip}; }

// The surface mirrored and turned, with its picture.
void turn(std::vector<dvec3>& normals, const PictureSource& source) {
    if (source.rotation == 0 && !source.flip) return;
    const double angle = source.rotation * (std::numbers::pi / 180), c = std::cos(angle), s = std::sin(angle);
    for (dvec3& n : normals) {
        const double x = source.flip ? -n.x : n.x;
        n = {c * x - s * n.y, s * x + c * n.y, n.z};
    }
}

std::shared_ptr<const Raster> stamped(const std::shared_ptr<const Raster>& picture,
                                      const PictureSource& source) {
    const dvec3 pole(0, 0, 1);
    const Brush brush{.radius = source.size, .hardness = 1, .flow = 1};
    Stroke stroke(*blank_raster(),
                  {.tool = PaintTool::stamp,
                   .brush = brush,
                   .symmetry = {},
                   .tip = picture,
                   .to_tip = stamp_from_layer(Layer{}, pole, pose_of(source))},
                  pole);
    auto raster = stroke.raster();
    if (!(raster_mass(*raster) > 0))
        throw UserError("", "stamp", "the picture must have something that paints", "all of it is black");
    return raster;
}

}  // namespace

ImportedPicture::ImportedPicture(fs::path file)
    : file_(std::move(file)), size_(size_of(file_)), time_(time_of(file_)) {}

bool ImportedPicture::is_current() const { return size_ == size_of(file_) && time_ == time_of(file_); }

const ImportedPicture::Data& ImportedPicture::data() {
    if (!data_) {
        Data data;
        data.colours = load_colours(file_, &data.notes);
        data.look = look_at_normal_map(data.colours);
        data_ = std::move(data);
    }
    return *data_;
}

const ColourPicture& ImportedPicture::colours() { return data().colours; }
const PictureNotes& ImportedPicture::notes() { return data().notes; }
const NormalMapLook& ImportedPicture::look() { return data().look; }

const ImportedPicture::Grey& ImportedPicture::stamp() {
    if (!stamp_) {
        Grey grey;
        grey.raster = std::make_shared<const Raster>(load_stamp(file_, &grey.notes));
        stamp_ = std::move(grey);
    }
    return *stamp_;
}

const ImportedPicture::Grey& ImportedPicture::modulation() {
    if (!modulation_) {
        Grey grey;
        grey.raster = std::make_shared<const Raster>(
            load_picture(file_, file_.string(), "modulation", PictureShape::any, &grey.notes));
        modulation_ = std::move(grey);
    }
    return *modulation_;
}

const LatLong& ImportedPicture::environment() {
    if (!environment_) environment_ = load_lat_long(file_);
    return *environment_;
}

int draft_step(const ColourPicture& picture) {
    const double pixels = static_cast<double>(picture.width) * picture.height;
    return std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels) / draft_side)));
}

MadeRaster made_raster(ImportedPicture& picture, const PictureSource& source, int step) {
    if (source.as == SourceUse::stamp)
        return {stamped(picture.stamp().raster, source), picture.stamp().notes};
    const bool heights = source.as == SourceUse::heights;
    const ColourPicture& colours = picture.colours();
    std::vector<dvec3> normals = heights ? normals_of_heights(colours, source.height / 100, step)
                                         : normals_of_map(colours, source.reading, step);
    turn(normals, source);
    MadeRaster made{raster_of_normals(normals, source.smoothing), picture.notes()};
    if (heights) return made;
    if (const std::string note = note_on(count_normals(colours, source.reading)); !note.empty())
        made.notes.insert(made.notes.begin(), note);
    return made;
}

MadeRaster made_modulation(ImportedPicture& picture, const Layer& layer, const PictureSource& source) {
    const auto& [given, notes] = picture.modulation();
    const glm::dmat2 to_picture = stamp_from_layer(layer, {0, 0, 1}, pose_of(source));
    auto turned = std::make_shared<Raster>(*given);
    std::size_t index = 0;
    for (int row = 0; row < given->height; ++row)
        for (int column = 0; column < given->width; ++column, ++index)
            turned->values[index] = static_cast<float>(raster_value(
                given->values, given->width, to_picture * texel_point(given->width, row, column)));
    return {std::move(turned), notes};
}

}  // namespace nacre
