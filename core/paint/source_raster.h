// Rasters that are made from a picture.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/image/picture.h"
#include "core/model/layer.h"
#include "core/paint/normal_map.h"

namespace nacre {

// A picture file, decoded when it is first asked for and once for each way to read it. What is wrong is a
// UserError of the picture. For one thread at a time.
class ImportedPicture {
  public:
    explicit ImportedPicture(std::filesystem::path file);

    const std::filesystem::path& file() const { return file_; }
    bool is_current() const;  // whether the file has the size and the time that it had

    struct Grey {
        std::shared_ptr<const Raster> raster;
        PictureNotes notes;
    };
    const ColourPicture& colours();  // the numbers that it holds
    const PictureNotes& notes();     // on them
    const NormalMapLook& look();     // at them, as normals
    const Grey& stamp();             // its light: see load_stamp()
    const Grey& modulation();        // its light: see load_picture(), of any shape
    const LatLong& environment();    // see load_lat_long()

  private:
    struct Data {
        ColourPicture colours;
        PictureNotes notes;
        NormalMapLook look;
    };
    const Data& data();

    std::filesystem::path file_;
    std::uintmax_t size_;
    std::filesystem::file_time_type time_;
    std::optional<Data> data_;
    std::optional<Grey> stamp_, modulation_;
    std::optional<LatLong> environment_;
};

struct MadeRaster {
    std::shared_ptr<const Raster> raster;
    PictureNotes notes;
};

// The raster of a painted layer that is made so, with a largest value of 1. Of normals and heights a `step`
// above 1 takes every step-th pixel of every step-th row, for a draft. A UserError where it would hold no
// facets.
MadeRaster made_raster(ImportedPicture& picture, const PictureSource& source, int step = 1);

// So that a draft takes some 65,000 pixels at most.
int draft_step(const ColourPicture& picture);

// A picture to modulate this layer by: upright where it shines, whatever the layer's rotation and tilt are,
// as a stamp is, and with the rotation and flip of `source`.
MadeRaster made_modulation(ImportedPicture& picture, const Layer& layer, const PictureSource& source);

}  // namespace nacre
