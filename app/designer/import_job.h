// Reads a picture that comes in and shows what would come of each use, on a worker.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/latest_job.h"
#include "core/model/layer.h"
#include "core/paint/density_picture.h"
#include "core/paint/picture_guess.h"
#include "core/paint/source_raster.h"

namespace nacre {

struct ImportRequest {
    PictureSource settings;  // its image is the picture
    bool by_look = true;     // how normals are read is told by the picture, but for green
    Layer modulated;         // that a modulation is for
    ScaleKind scale = ScaleKind::perceptual;
    ImportUse use = ImportUse::stamp;  // shown first
    bool make = false;                 // for good, of all pixels, and nothing is shown
};

// What one use would bring, as a small square picture: the highlight the way up that it shines, of an
// environment the picture.
struct ImportPreview {
    HemispherePicture picture;
    std::string refusal;  // in words; empty where it can be used so
    PictureNotes notes;
};

struct ImportSight {
    PictureSource settings;  // that it is seen with
    NormalMapLook look;
    PictureGuess guess{ImportUse::stamp, {}};
    std::array<std::shared_ptr<const ImportPreview>, import_uses> previews;  // null while not yet made
    std::optional<MadeRaster> made;                                          // where that was asked for
    std::shared_ptr<const Raster> stamp;  // the picture itself, where that is made
};

// The work. Remembers the picture that it has read last, and what it has shown of it.
class ImportWorker {
  public:
    static constexpr int side = 160;  // pixels of a preview

    using Publish = std::function<void(ImportSight)>;
    // The sight is published whenever a preview more is there. A UserError where the picture cannot be read.
    void work(const ImportRequest& request, const std::stop_token& stop, const Publish& publish);

  private:
    struct Shown {
        PictureSource settings;
        Layer modulated;
        std::shared_ptr<const ImportPreview> preview;
    };
    void read(const ImportRequest& request);
    void make(const ImportRequest& request);
    ImportPreview preview(ImportUse use, const ImportRequest& request);
    HemispherePicture highlight(ImportUse use, const ImportRequest& request, PictureNotes& notes);

    std::unique_ptr<ImportedPicture> picture_;
    std::array<std::optional<Shown>, import_uses> shown_;
    ImportSight sight_;
};

}  // namespace nacre
