// Whether files still hold what they did, looked up on a thread of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/latest_job.h"
#include "core/base/system/file_content.h"

namespace nacre {

struct FileChange {
    std::filesystem::path file;
    FileContent before;
    std::optional<FileContent> now;  // none: it is gone, or cannot be read any more
};

class FileWatch {
  public:
    // `notify` as in LatestJob.
    explicit FileWatch(std::function<void()> notify = {});

    void look(HeldFiles files) { job_.submit(std::move(files)); }

    // What has changed among the files that were looked at last, once.
    std::optional<std::vector<FileChange>> poll();

    void wait() const { job_.wait(); }

  private:
    LatestJob<HeldFiles, std::vector<FileChange>> job_;
};

}  // namespace nacre
