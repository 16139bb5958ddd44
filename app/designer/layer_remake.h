// Makes the raster of a layer again from its picture, with other settings, on a worker.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/latest_job.h"
#include "core/paint/source_raster.h"
#include "ui/layers_panel.h"

namespace nacre {

class LayerRemake {
  public:
    // `wake` is called on the worker's thread when there is something to take.
    explicit LayerRemake(std::function<void()> wake = {});

    // Once a frame: asks for what the panel wants, and puts what has come into the layer, settings and raster
    // together: a draft first where the picture is large. What was painted on or taken back meanwhile stays
    // as it is.
    void follow(ui::LayersView& view, Distribution& distribution);

    // What has been set is still to come: the edit has not ended.
    bool busy() const { return pending_.has_value(); }
    void wait() const { job_.wait(); }

  private:
    struct Made {
        PictureSource source;
        std::shared_ptr<const Raster> raster;
        bool draft = false;
    };
    struct Pending {
        ui::LayersView::Remake wanted;
        std::shared_ptr<const Raster> raster;  // that the layer has
    };
    using Job = LatestJob<PictureSource, Made>;

    void take(Job::Published published, ui::LayersView& view, Distribution& distribution);
    void ask(const ui::LayersView& view, const Distribution& distribution);

    std::optional<Pending> pending_;
    std::uint64_t asked_ = 0, first_ = 0;  // the newest request, and the first whose answer counts
    Job job_;
};

}  // namespace nacre
