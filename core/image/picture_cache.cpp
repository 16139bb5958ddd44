#include "core/image/picture_cache.h"

#include <algorithm>
#include <cstdint>
#include <list>
#include <mutex>
#include <utility>

#include "core/base/input_file.h"

namespace nacre {
namespace {

constexpr std::size_t bytes_max = 64u << 20;
constexpr std::uintmax_t worth_reading = std::uintmax_t{1} << 32;  // bytes: more than any picture may have

struct Entry {
    FileContent content;
    std::string use;
    KeptPicture kept;
    std::size_t bytes;
};

// The last used first.
struct Cache {
    std::mutex mutex;
    std::list<Entry> entries;
    std::size_t bytes = 0;
};

Cache& cache() {
    static Cache kept;
    return kept;
}

}  // namespace

std::optional<FileContent> picture_file_content(const std::filesystem::path& file) {
    return input_file_problem(file, worth_reading).empty() ? content_of_file(file) : std::nullopt;
}

std::optional<KeptPicture> kept_picture(const FileContent& content, const std::string& use) {
    Cache& kept = cache();
    const std::lock_guard lock(kept.mutex);
    const auto found = std::find_if(kept.entries.begin(), kept.entries.end(), [&](const Entry& entry) {
        return entry.content == content && entry.use == use;
    });
    if (found == kept.entries.end()) return {};
    kept.entries.splice(kept.entries.begin(), kept.entries, found);
    return found->kept;
}

void keep_picture(const FileContent& content, const std::string& use, KeptPicture picture,
                  std::size_t bytes) {
    if (bytes > bytes_max) return;
    Cache& kept = cache();
    const std::lock_guard lock(kept.mutex);
    kept.entries.push_front({content, use, std::move(picture), bytes});
    kept.bytes += bytes;
    while (kept.bytes > bytes_max) {
        kept.bytes -= kept.entries.back().bytes;
        kept.entries.pop_back();
    }
}

}  // namespace nacre
