#include "app/designer/bake_job.h"

#include <utility>

#include "core/base/error.h"
#include "core/base/system/thread_priority.h"
#include "core/design/design_check.h"

namespace nacre {
namespace {

using Job = LatestJob<BakeRequest, std::shared_ptr<const Tables>>;

// Nice level of the worker: where cores are few, drawing goes first. Threads that the worker starts
// inherit it.

bool same_draft(const BakeRequest& a, const BakeRequest& b) {
    return a.design == b.design && a.albedo == b.albedo;
}

// `drafted` is the request whose draft was published last: it needs no other.
void bake_in_steps(Baker& baker, std::optional<BakeRequest>& drafted, const BakeRequest& request,
                   const std::stop_token& stop, const Job::Publish& publish, int threads) {
    set_niceness(worker_niceness);
    check_design(request.design, "design");
    for (const BakeOptions& step : bake_steps(request.design)) {
        const bool draft = step.quality == Quality::draft, same = drafted && same_draft(*drafted, request);
        if (draft ? same : !request.settled) continue;
        BakeOptions options = step;
        options.albedo = request.albedo;
        options.threads = threads;
        publish(baker.bake(request.design, options, stop, {}, request.p));
        if (draft) drafted = request;
        if (stop.stop_requested()) return;
    }
}

}  // namespace

BakeJob::BakeJob(int threads, std::function<void()> notify)
    : job_(
          [this, threads](const BakeRequest& request, const std::stop_token& stop,
                          const Job::Publish& publish) {
              bake_in_steps(baker_, drafted_, request, stop, publish, threads);
          },
          std::move(notify)) {}

void BakeJob::want(const BakeRequest& request) {
    if (wanted_ == request) return;
    draft_due_ = draft_due_ || !wanted_ || !same_draft(*wanted_, request);
    wanted_ = request;
    asked_ = job_.submit(request);
}

std::shared_ptr<const Tables> BakeJob::poll(std::chrono::milliseconds patience) {
    const bool worth_it = std::exchange(draft_due_, false) && last_draft_ <= patience;
    const auto published = job_.poll(worth_it ? patience : std::chrono::milliseconds(0));
    if (!published) return nullptr;
    answered_ = published->revision;
    problem_ = published->error ? plain_words(published->error) : std::string();
    auto tables = published->result.value_or(nullptr);
    if (tables && tables->quality == Quality::draft)
        last_draft_ = std::chrono::duration<double>(tables->seconds);
    return tables;
}

}  // namespace nacre
