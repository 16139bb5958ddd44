// Pictures as the shader reads them.
#pragma once

#include <memory>

#include "core/model/disk_texels.h"
#include "core/model/modulation.h"
#include "core/model/shading.h"

namespace nacre {

// A picture as the shader reads it.
class PictureReader {
  public:
    explicit PictureReader(const Raster& picture)
        : raster_(std::make_shared<const Raster>(extended_past_rim(picture))) {
        shading_.data = raster_->values.data();
    }
    double operator()(dvec3 h) const { return shading_.picture_value(h, 0, raster_->width); }
    double operator()(dvec2 at) const { return shading_.picture_at(at.x, at.y, 0, raster_->width); }
    const std::shared_ptr<const Raster>& raster() const { return raster_; }

  private:
    std::shared_ptr<const Raster> raster_;
    Shading<double> shading_;
};

// 1 - strength + strength * picture.
class ModulationFactor {
  public:
    explicit ModulationFactor(const Modulation& modulation)
        : strength_(modulation.strength), picture_(*modulation.image.raster) {
        const double brightest = static_cast<double>(largest_on_disk(*modulation.image.raster));
        peak_ = of(brightest);
    }
    template <class Place>
    double operator()(Place at) const {
        return of(picture_(at));
    }
    double of(double picture) const { return 1 - strength_ + strength_ * picture; }
    const Raster& picture() const { return *picture_.raster(); }  // as it is read
    double peak() const { return peak_; }
    int side() const { return picture_.raster()->width; }

  private:
    double strength_;
    PictureReader picture_;
    double peak_ = 1;
};

}  // namespace nacre
