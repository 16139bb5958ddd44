#include "core/image/picture_cache.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <list>
#include <mutex>
#include <string_view>
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

std::optional<FileContent> content_of(const std::filesystem::path& file) {
    constexpr std::size_t block_size = 1u << 20;
    if (!input_file_problem(file, worth_reading).empty()) return {};
    std::ifstream stream(file, std::ios::binary);
    std::string block(block_size, '\0');
    FileContent content;
    do {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        const auto count = static_cast<std::size_t>(stream.gcount());
        content.size += count;
        content.hash = content.hash * 0x9E3779B97F4A7C15u +
                       std::hash<std::string_view>()(std::string_view(block).substr(0, count));
    } while (stream);
    return stream.bad() ? std::nullopt : std::optional(content);
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
