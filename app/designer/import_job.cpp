#include "app/designer/import_job.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <utility>

#include "app/designer/picture_trouble.h"
#include "core/image/clear_part.h"
#include "core/image/luminance.h"
#include "core/image/srgb.h"
#include "core/model/facet_distribution.h"

namespace nacre {
namespace {

constexpr double mean_shown = 0.25;  // luminance of an environment's preview, linear

SourceUse source_use(ImportUse use) {
    return use == ImportUse::normals   ? SourceUse::normals
           : use == ImportUse::heights ? SourceUse::heights
                                       : SourceUse::stamp;
}

PictureSource source_for(ImportUse use, PictureSource settings) {
    settings.as = source_use(use);
    return settings;
}

// As wide as the square, with nothing above and below.
HemispherePicture picture_of_light(const LatLong& light, int side) {
    double sum = 0;
    for (const glm::vec3& c : light.radiance) sum += luminance(glm::dvec3(c));
    const double mean = sum / static_cast<double>(light.radiance.size());
    const double gain = mean > 0 ? mean_shown / mean : 1;
    HemispherePicture picture{{side, side},
                              std::vector<std::uint8_t>(static_cast<std::size_t>(side) * side * 4)};
    const int height = side / 2, top = side / 4;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < side; ++column) {
            const glm::dvec2 at((column + 0.5) / side, (row + 0.5) / height);
            const glm::dvec3 c = gain * radiance_at(light, at);
            std::uint8_t* const pixel =
                &picture.rgba[static_cast<std::size_t>((top + row) * side + column) * 4];
            for (int i = 0; i < 3; ++i)
                pixel[i] = static_cast<std::uint8_t>(std::lround(255 * srgb_encoded(std::min(c[i], 1.0))));
            pixel[3] = 255;
        }
    return picture;
}

// The uses, the first one first.
std::array<ImportUse, import_uses> in_turn(ImportUse first) {
    std::array<ImportUse, import_uses> uses{};
    for (std::size_t i = 0; i < import_uses; ++i) uses[i] = static_cast<ImportUse>(i);
    const auto at = std::find(uses.begin(), uses.end(), first);
    std::rotate(uses.begin(), at, at + 1);
    return uses;
}

}  // namespace

// A picture that is too large for anything else may still be an environment.
void ImportWorker::read(const ImportRequest& request) {
    const std::filesystem::path& file = request.settings.image;
    if (!file.empty() && picture_ && picture_->file() == file && picture_->is_current()) return;
    picture_.reset();
    shown_ = {};
    sight_ = {};
    if (file.empty()) return;
    auto picture = std::make_unique<ImportedPicture>(file);
    try {
        sight_.look = picture->look();
        PictureStatistics measured = picture_statistics(picture->colours(), sight_.look.reading);
        measured.clear = std::max(measured.clear, load_clear_part(file));  // numbers come without alpha
        sight_.guess = likely_use(measured);
    } catch (const std::exception&) {
        const std::exception_ptr problem = std::current_exception();
        try {
            picture->environment();
        } catch (const std::exception&) {
            std::rethrow_exception(problem);
        }
        sight_.guess = {ImportUse::environment, "nothing else can be this large"};
    }
    picture_ = std::move(picture);
}

HemispherePicture ImportWorker::highlight(ImportUse use, const ImportRequest& request, PictureNotes& notes) {
    Distribution alone;
    Layer& layer = alone.layers[0];
    const PictureSource source = source_for(use, sight_.settings);
    if (use == ImportUse::modulation) {
        layer = request.modulated;
        layer.enabled = true;
        layer.weight = 1;
        MadeRaster made = made_modulation(*picture_, layer, source);
        notes = std::move(made.notes);
        layer.modulation = Modulation{{{}, std::move(made.raster)}, 1};
    } else {
        const int step = use == ImportUse::stamp ? 1 : draft_step(picture_->colours());
        MadeRaster made = made_raster(*picture_, source, step);
        notes = std::move(made.notes);
        layer.lobe = PaintedLobe{{{}, std::move(made.raster)}};
    }
    const FacetDistribution p(alone);
    const HemisphereView view(HemisphereCamera{}, {side, side});
    return density_picture(&p, view, {.peak = peak_density(p), .kind = request.scale}, 1);
}

ImportPreview ImportWorker::preview(ImportUse use, const ImportRequest& request) {
    ImportPreview made;
    try {
        if (use == ImportUse::environment)
            made.picture = picture_of_light(picture_->environment(), side);
        else
            made.picture = highlight(use, request, made.notes);
    } catch (const std::exception&) {
        made.refusal = sentence(reason_of(std::current_exception()));
    }
    return made;
}

void ImportWorker::make(const ImportRequest& request) {
    const PictureSource source = source_for(request.use, request.settings);
    sight_.settings = source;
    if (request.use == ImportUse::modulation)
        sight_.made = made_modulation(*picture_, request.modulated, source);
    else
        sight_.made = made_raster(*picture_, source);
    if (request.use == ImportUse::stamp) sight_.stamp = picture_->stamp().raster;
}

void ImportWorker::work(const ImportRequest& request, const std::stop_token& stop, const Publish& publish) {
    read(request);
    if (!picture_) return;
    sight_.settings = request.settings;
    if (request.by_look) {
        sight_.settings.reading = sight_.look.reading;
        sight_.settings.reading.green_down = request.settings.reading.green_down;
    }
    if (request.make) {
        make(request);
        publish(sight_);
        sight_.made.reset();
        sight_.stamp.reset();
        return;
    }
    for (const ImportUse use : in_turn(request.by_look ? sight_.guess.use : request.use)) {
        const auto index = static_cast<std::size_t>(use);
        std::optional<Shown>& shown = shown_[index];
        const bool stays = use == ImportUse::environment;
        if (!shown ||
            (!stays && (shown->settings != sight_.settings || shown->modulated != request.modulated)))
            shown = Shown{sight_.settings, request.modulated,
                          std::make_shared<const ImportPreview>(preview(use, request))};
        sight_.previews[index] = shown->preview;
        publish(sight_);
        if (stop.stop_requested()) return;
    }
}

}  // namespace nacre
