// One highlight of a painted layer, to be dragged.
#pragma once

#include <memory>
#include <optional>

#include "core/image/raster.h"
#include "core/model/lobe.h"

namespace nacre {

// The watershed region (hill) of paint under a normal: all points from which going uphill leads to the same
// peak. The picture is smoothed over some three degrees for that, and a bump that rises by less
// than a quarter of its height is no hill of its own, so that neither grain nor the ripple of a stroke splits
// a highlight. Where two hills meet, the valley divides them, softly over about a degree.
class Highlight {
  public:
    // Under `at`, a unit vector in the layer's frame; nothing where no paint is. `raster` as paintable()
    // gives it.
    static std::optional<Highlight> under(const Raster& raster, dvec3 at);

    // The picture with the hill carried along by the shortest rotation from where it was taken to `to`, a
    // unit vector in the layer's frame or the rim for one below it, and added to what lies there; the rest
    // stays. The hill keeps its mass against the rest's, also where some of it would move below the horizon:
    // the remainder holds that too. Values stay in [0, 1]: where hills pile up higher the whole picture is
    // taken by one factor, which changes nothing of p. Null where all of it would.
    std::shared_ptr<const Raster> carried(dvec3 to) const;

    const Raster& part() const { return part_; }  // the hill alone; part() + rest() is the picture
    const Raster& rest() const { return rest_; }

  private:
    Highlight(const Raster& raster, dvec3 at, const std::vector<float>& membership);

    Raster part_, rest_;
    dvec3 at_;
    double reach_ = 0;  // radians about at_ within which the hill lies
};

}  // namespace nacre
