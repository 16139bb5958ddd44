// Small pictures of designs on the disk: baked on a worker, drawn by the preview, at most one in a frame.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/designer/folder.h"
#include "app/preview/preview.h"
#include "core/base/latest_job.h"

namespace nacre {

// Needs a current OpenGL 3.3 context from its beginning to its end.
class Thumbnails {
  public:
    static constexpr int side = 160;  // pixels

    Thumbnails();

    // Once in each frame that shows them. Goes on with the next one that is missing.
    void follow(const std::vector<Preset>& presets);

    // Null while there is no picture, and for a design that cannot be baked.
    ImTextureID texture(const std::filesystem::path& file) const;

    bool busy() const { return job_.busy(); }

  private:
    void draw(const std::filesystem::path& file, std::shared_ptr<const Tables> tables);

    std::map<std::filesystem::path, std::unique_ptr<Texture>> pictures_;  // null: it cannot be
    std::optional<std::filesystem::path> baking_;
    std::unique_ptr<Preview> preview_;
    LatestJob<std::filesystem::path, std::shared_ptr<const Tables>> job_;
};

}  // namespace nacre
