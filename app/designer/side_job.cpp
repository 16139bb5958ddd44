#include "app/designer/side_job.h"

#include "app/designer/bake_job.h"
#include "core/base/error.h"
#include "core/base/system/thread_priority.h"
#include "core/design/design_check.h"

namespace nacre {
namespace {

using Job = LatestJob<SideRequest, ComparedSurface>;

void bake_side(Baker& baker, const SideRequest& request, const std::stop_token& stop,
               const Job::Publish& publish, int threads) {
    set_niceness(worker_niceness);
    check_design(request.design, "design");
    for (const BakeOptions& step : bake_steps(request.design)) {
        if (step.quality == Quality::final && !request.settled) return;
        BakeOptions options = step;
        options.albedo = request.albedo;
        options.threads = threads;
        publish(bake_for_comparison(baker, request.design, request.comparison_model, options, stop));
        if (stop.stop_requested()) return;
    }
}

}  // namespace

SideJob::SideJob(int threads, std::function<void()> notify)
    : job_([this, threads](
               const SideRequest& request, const std::stop_token& stop,
               const Job::Publish& publish) { bake_side(baker_, request, stop, publish, threads); },
           std::move(notify)) {}

void SideJob::want(const SideRequest& request) {
    if (wanted_ == request) return;
    wanted_ = request;
    asked_ = job_.submit(request);
}

std::optional<ComparedSurface> SideJob::poll() {
    auto published = job_.poll();
    if (!published || published->revision < first_) return {};
    problem_ = published->error ? plain_words(published->error) : std::string();
    return std::move(published->result);
}

}  // namespace nacre
