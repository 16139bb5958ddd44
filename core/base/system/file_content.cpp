#include "core/base/system/file_content.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <vector>

namespace nacre {
namespace {

constexpr std::size_t piece = std::size_t{1} << 20;  // bytes; whole words
constexpr std::uint64_t odd = 0x9e3779b97f4a7c15u;   // 2^64 over the golden ratio

// Each step is one to one in the word and in what was there before, so that no single word can change unseen.
class Digest {
  public:
    // All but the last call take whole words.
    void add(std::string_view bytes) {
        content_.bytes += bytes.size();
        for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
            content_.digest = (content_.digest ^ word) * odd;
            content_.digest ^= content_.digest >> 32;
        }
    }
    const FileContent& content() const { return content_; }

  private:
    FileContent content_;
};

struct OpenFile {
    explicit OpenFile(const std::filesystem::path& file)
        : descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (descriptor >= 0) ::close(descriptor);
    }

    bool is_regular() const {
        struct stat status {};
        return descriptor >= 0 && ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    }

    // Fills the buffer unless the file ends; negative where it cannot be read.
    ssize_t fill(std::vector<char>& buffer) const {
        std::size_t filled = 0;
        while (filled < buffer.size()) {
            const ssize_t got = ::read(descriptor, buffer.data() + filled, buffer.size() - filled);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) return got;
            if (got == 0) break;
            filled += static_cast<std::size_t>(got);
        }
        return static_cast<ssize_t>(filled);
    }

    const int descriptor;
};

}  // namespace

FileContent content_of(std::string_view bytes) {
    Digest digest;
    digest.add(bytes);
    return digest.content();
}

std::optional<FileContent> content_of_file(const std::filesystem::path& file) {
    const OpenFile opened(file);
    if (!opened.is_regular()) return {};
    Digest digest;
    std::vector<char> buffer(piece);
    for (;;) {
        const ssize_t filled = opened.fill(buffer);
        if (filled < 0) return {};
        digest.add({buffer.data(), static_cast<std::size_t>(filled)});
        if (static_cast<std::size_t>(filled) < buffer.size()) return digest.content();
    }
}

std::string content_text(const FileContent& content) {
    return fmt::format("{}-{:016x}", content.bytes, content.digest);
}

std::optional<FileContent> parse_content(std::string_view text) {
    FileContent content;
    const char* const end = text.data() + text.size();
    const auto size = std::from_chars(text.data(), end, content.bytes);
    if (size.ec != std::errc() || size.ptr == end || *size.ptr != '-') return {};
    const auto digest = std::from_chars(size.ptr + 1, end, content.digest, 16);
    if (digest.ec != std::errc() || digest.ptr != end || content_text(content) != text) return {};
    return content;
}

std::optional<FileContent> content_in(const HeldFiles& held, const std::filesystem::path& file) {
    const auto found = held.find(file);
    return found == held.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace nacre
