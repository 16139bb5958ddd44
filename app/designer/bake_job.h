// The bake on the worker: a draft within milliseconds, then, once the design is settled, the final tables.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/bake/baker.h"
#include "core/base/latest_job.h"
#include "core/design/design.h"

namespace nacre {

struct BakeRequest {
    Design design;
    std::shared_ptr<const FacetDistribution> p;  // of the design, if it is made already
    bool albedo = false;                         // R is wanted even where no diffuse term reads it
    bool settled = true;                         // false while a hand still moves something: a draft will do
    bool operator==(const BakeRequest& other) const {
        return design == other.design && albedo == other.albedo && settled == other.settled;
    }
};

class BakeJob {
  public:
    // `notify` is called on the worker's thread when there is something to poll, and when it falls idle.
    explicit BakeJob(int threads, std::function<void()> notify = {});

    // Starts a bake unless this is what was asked for last.
    void want(const BakeRequest& request);

    // The newest tables since the last call, or null; keeps `problem` up to date. Waits up to `patience` for
    // a draft that has been asked for since the last call, where the one before took no longer than that.
    std::shared_ptr<const Tables> poll(std::chrono::milliseconds patience = {});

    // Why the newest finished request was refused, in plain words; empty when it was not.
    const std::string& problem() const { return problem_; }
    bool busy() const { return job_.busy(); }

    // Numbers of the newest request and of the one that the last polled tables are for.
    std::uint64_t asked() const { return asked_; }
    std::uint64_t answered() const { return answered_; }
    void wait() const { job_.wait(); }

  private:
    Baker baker_;                         // only the worker calls it and reads the next
    std::optional<BakeRequest> drafted_;  // whose draft was published last
    std::optional<BakeRequest> wanted_;
    std::string problem_;
    std::uint64_t asked_ = 0, answered_ = 0;
    bool draft_due_ = false;                      // asked for since the last poll
    std::chrono::duration<double> last_draft_{};  // what it took
    LatestJob<BakeRequest, std::shared_ptr<const Tables>> job_;
};

}  // namespace nacre
