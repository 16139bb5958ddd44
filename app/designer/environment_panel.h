// What surrounds the object: chosen from a list or a file, made on a worker.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/preview/scene.h"
#include "core/bake/latest_job.h"
#include "core/light/environment.h"
#include "ui/dialogs.h"

namespace nacre {

class EnvironmentPanel {
  public:
    EnvironmentPanel();

    // The rows of the light's panel.
    void rows(Surroundings& surroundings);

    // The file dialog, and the answer of the worker; once a frame.
    void draw(Surroundings& surroundings);

    // A procedural environment's name, or a picture by latitude and longitude. The present one stays until it
    // has come, and where it cannot be used.
    void want(std::string name_or_file);

    bool talking() const { return dialog_ || !problem_.empty(); }
    bool busy() const { return wanted_.has_value(); }
    void wait() const { job_.wait(); }

  private:
    std::optional<std::string> wanted_;
    std::string last_file_;  // stays in the list
    std::optional<ui::FileDialog> dialog_;
    std::string problem_;
    std::uint64_t asked_ = 0;
    LatestJob<std::string, std::shared_ptr<const Environment>> job_;
};

}  // namespace nacre
