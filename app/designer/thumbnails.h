// Small pictures of designs: baked on a worker, drawn by the preview, at most one in a frame.
#pragma once

#include <imgui.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/preview/preview.h"
#include "core/base/latest_job.h"
#include "core/design/design.h"

namespace nacre {

// Needs a current OpenGL 3.3 context from its beginning to its end.
class Thumbnails {
  public:
    static constexpr int side = 160;  // pixels

    struct Wanted {
        std::string name;                // of no other design, ever
        std::function<Design()> design;  // called on the worker's thread; may throw
    };

    Thumbnails();

    // Once in each frame that shows them. Goes on with the next one that is missing, and forgets those that
    // are not wanted any more.
    void follow(const std::vector<Wanted>& wanted);

    // Null while there is no picture, and for a design that cannot be baked.
    ImTextureID texture(const std::string& name) const;

    bool busy() const { return job_.busy(); }
    void wait() const { job_.wait(); }

  private:
    void draw(const std::string& name, std::shared_ptr<const Tables> tables);

    std::map<std::string, std::unique_ptr<Texture>> pictures_;  // null: it cannot be
    std::optional<std::string> baking_;
    std::unique_ptr<Preview> preview_;
    LatestJob<Wanted, std::shared_ptr<const Tables>> job_;
};

}  // namespace nacre
