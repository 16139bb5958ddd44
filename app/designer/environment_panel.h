// The environment of the object: chosen from a list or a file, made on a worker.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/designer/file_chooser.h"
#include "app/preview/scene.h"
#include "core/base/latest_job.h"
#include "core/base/system/file_content.h"
#include "core/light/environment.h"

namespace nacre {

class EnvironmentPanel {
  public:
    EnvironmentPanel();

    // The rows of the light's panel. `dialogs` asks for a picture where one is wanted.
    void rows(SceneEnvironment& environment, const std::optional<DialogProgram>& dialogs);

    // Takes what the worker has made; once a frame.
    void follow(SceneEnvironment& environment);

    // The dialog or the problem, where one is open.
    void talk();
    bool talking() const { return chooser_.open() || !problem_.empty(); }
    const std::string& problem() const { return problem_; }  // shown until it is read

    // A procedural environment's name, or a lat-long picture. The present one stays until it
    // has come, and where it cannot be used.
    void want(std::string name_or_file);

    bool in_motion() const { return wanted_ || chooser_.has_answer(); }
    void wait() const { job_.wait(); }

    // What the file of the present picture held when it was read; empty where it came from none.
    HeldFiles& held() { return held_; }
    const HeldFiles& held() const { return held_; }

  private:
    struct Read {
        std::shared_ptr<const Environment> picture;
        HeldFiles held;
    };

    std::optional<std::string> wanted_;
    std::string last_file_;  // stays in the list
    FileChooser chooser_;
    std::string problem_;
    HeldFiles held_;
    std::uint64_t asked_ = 0;
    LatestJob<std::string, Read> job_;
};

}  // namespace nacre
