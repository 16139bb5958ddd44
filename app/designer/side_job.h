// What stands at one side of a comparison, baked on a worker of its own: a draft at once, then the final
// tables.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/base/latest_job.h"
#include "core/compare/comparison_model.h"

namespace nacre {

struct SideRequest {
    Design design;
    std::optional<ComparisonModel> comparison_model;  // without one: the design itself
    bool albedo = false;                              // R is wanted even where no diffuse term reads it
    bool settled = true;  // false while a hand still moves something: a draft will do
    bool operator==(const SideRequest&) const = default;
};

class SideJob {
  public:
    // `notify` as in LatestJob.
    explicit SideJob(int threads, std::function<void()> notify = {});

    // Starts a bake unless this is what was asked for last.
    void want(const SideRequest& request);

    // Something else is wanted from now on: what is still to come of earlier requests is not.
    void forget() {
        wanted_.reset();
        first_ = asked_ + 1;
    }

    // The newest surface since the last call; keeps `problem` up to date.
    std::optional<ComparedSurface> poll();

    // Why the newest finished request was refused, in plain words; empty when it was not.
    const std::string& problem() const { return problem_; }
    bool busy() const { return job_.busy(); }
    void wait() const { job_.wait(); }

  private:
    Baker baker_;  // only the worker calls it
    std::optional<SideRequest> wanted_;
    std::string problem_;
    std::uint64_t asked_ = 0, first_ = 0;  // numbers of the newest request, and of the first that counts
    LatestJob<SideRequest, ComparedSurface> job_;
};

}  // namespace nacre
