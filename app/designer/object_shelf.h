// Makes the preview's objects on a thread of its own: a file may be large.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/preview/object.h"
#include "core/base/latest_job.h"
#include "core/base/system/file_content.h"

namespace nacre {

class ObjectShelf {
  public:
    ObjectShelf();

    void want(const std::string& name);  // see make_object()

    // What is wanted, once it is made; keeps `problem` up to date.
    std::optional<SceneObject> poll();

    // Why the newest wish could not be made, in one line; empty when it could.
    const std::string& problem() const { return problem_; }
    void forget_problem() { problem_.clear(); }

    const std::string& wanted() const { return wanted_; }

    // What the file of the newest object held when it was read; empty where it came from none.
    HeldFiles& held() { return held_; }
    const HeldFiles& held() const { return held_; }
    bool busy() const { return waiting_; }
    void wait() const { job_.wait(); }

  private:
    struct Made {
        SceneObject object;
        HeldFiles held;
    };

    std::map<std::string, SceneObject> made_;  // without files, which may change; only the worker reads it
    std::string wanted_ = SceneObject().name;
    std::string problem_;
    HeldFiles held_;
    bool waiting_ = false;  // for an answer that has not been polled
    LatestJob<std::string, Made> job_;
};

}  // namespace nacre
