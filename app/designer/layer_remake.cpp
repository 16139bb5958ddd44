#include "app/designer/layer_remake.h"

#include <utility>

#include "app/designer/picture_trouble.h"

namespace nacre {
namespace {

// Null where it is not a layer that a picture made.
const Raster* raster_of(const Distribution& distribution, std::size_t index) {
    if (index >= distribution.layers.size() || !distribution.layers[index].source) return nullptr;
    const auto* painted = std::get_if<PaintedLobe>(&distribution.layers[index].lobe);
    return painted != nullptr ? painted->image.raster.get() : nullptr;
}

}  // namespace

LayerRemake::LayerRemake(std::function<void()> wake)
    : job_(
          [kept = std::make_shared<std::unique_ptr<ImportedPicture>>()](
              const PictureSource& source, const std::stop_token& stop, const auto& publish) {
              std::unique_ptr<ImportedPicture>& picture = *kept;
              if (!picture || picture->file() != source.image || !picture->is_current())
                  picture = std::make_unique<ImportedPicture>(source.image);
              const bool all = source.as == SourceUse::stamp;
              const int step = all ? 1 : draft_step(picture->colours());
              if (step > 1) publish({source, made_raster(*picture, source, step).raster, true});
              if (!stop.stop_requested()) publish({source, made_raster(*picture, source).raster, false});
          },
          std::move(wake)) {}

void LayerRemake::take(Job::Published published, ui::LayersView& view, Distribution& distribution) {
    if (published.error) {
        view.source_trouble = {pending_->wanted.source.image,
                               picture_trouble(pending_->wanted.source.image, published.error)};
        view.remake.reset();
        return;
    }
    Layer& layer = distribution.layers[pending_->wanted.layer];
    layer.source = published.result->source;
    std::get<PaintedLobe>(layer.lobe).image = {{}, published.result->raster};
    pending_->raster = published.result->raster;
    view.source_trouble.reset();
    if (!published.result->draft && published.revision == asked_) view.remake.reset();
}

void LayerRemake::ask(const ui::LayersView& view, const Distribution& distribution) {
    const ui::LayersView::Remake& wanted = *view.remake;
    if (pending_ && pending_->wanted == wanted) return;
    const auto& lobe = std::get<PaintedLobe>(distribution.layers[wanted.layer].lobe);
    pending_ = Pending{wanted, lobe.image.raster};
    asked_ = job_.submit(wanted.source);
}

void LayerRemake::follow(ui::LayersView& view, Distribution& distribution) {
    auto published = job_.poll();
    const bool stands = view.remake && raster_of(distribution, view.remake->layer) != nullptr &&
                        (!pending_ || pending_->wanted.layer != view.remake->layer ||
                         raster_of(distribution, view.remake->layer) == pending_->raster.get());
    if (!stands) view.remake.reset();
    if (pending_ && view.remake && published && published->revision >= first_)
        take(*std::move(published), view, distribution);
    if (view.remake) return ask(view, distribution);
    pending_.reset();
    first_ = asked_ + 1;
}

}  // namespace nacre
