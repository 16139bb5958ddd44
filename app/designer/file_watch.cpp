#include "app/designer/file_watch.h"

#include <utility>

#include "core/base/system/thread_priority.h"

namespace nacre {
namespace {

using Job = LatestJob<HeldFiles, std::vector<FileChange>>;

void look_at(const HeldFiles& files, const std::stop_token&, const Job::Publish& publish) {
    set_niceness(worker_niceness);
    std::vector<FileChange> changes;
    for (const auto& [file, before] : files)
        if (const auto now = content_of_file(file); now != before) changes.push_back({file, before, now});
    publish(std::move(changes));
}

}  // namespace

FileWatch::FileWatch(std::function<void()> notify) : job_(look_at, std::move(notify)) {}

std::optional<std::vector<FileChange>> FileWatch::poll() {
    auto published = job_.poll();
    return published ? std::move(published->result) : std::nullopt;
}

}  // namespace nacre
