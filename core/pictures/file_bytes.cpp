#include "core/pictures/file_bytes.h"

#include <algorithm>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/base/input_file.h"
#include "core/pictures/picture_problem.h"

namespace nacre {

constexpr std::size_t window_size = 1u << 16;

FileBytes::FileBytes(const std::filesystem::path& file, std::uintmax_t most) : path_(file) {
    if (const std::string problem = input_file_problem(file, most); !problem.empty())
        throw PictureProblem(problem);
    try {
        file_.emplace(file);
    } catch (const std::system_error& error) {
        throw PictureProblem(error.code().message());
    }
}

std::size_t FileBytes::read(std::uint64_t offset, void* to, std::size_t length) const {
    if (offset >= size()) return 0;
    length = static_cast<std::size_t>(std::min<std::uint64_t>(length, size() - offset));
    if (length >= window_size) return file_->read(offset, to, length);
    const std::lock_guard lock(mutex_);
    if (offset < window_start_ || offset + length > window_start_ + window_.size()) {
        window_.resize(window_size);
        window_.resize(file_->read(offset, window_.data(), window_size));
        window_start_ = offset;
    }
    const std::size_t have =
        std::min(length, window_.size() - static_cast<std::size_t>(offset - window_start_));
    std::memcpy(to, window_.data() + (offset - window_start_), have);
    return have;
}

std::string FileBytes::read(std::uint64_t offset, std::uint64_t length) const {
    length = offset < size() ? std::min(length, size() - offset) : 0;
    std::string bytes(static_cast<std::size_t>(length), '\0');
    bytes.resize(read(offset, bytes.data(), bytes.size()));
    return bytes;
}

PieceProxy::PieceProxy(const FileBytes& file, std::vector<Piece> pieces)
    : IOProxy("", Read), file_(file), pieces_(std::move(pieces)) {
    for (Piece& piece : pieces_) {
        if (!piece.bytes.empty()) piece.length = piece.bytes.size();
        starts_.push_back(size_);
        size_ += static_cast<std::size_t>(piece.length);
    }
}

std::size_t PieceProxy::read(void* to, std::size_t length) {
    const std::size_t done = pread(to, length, m_pos);
    m_pos += static_cast<std::int64_t>(done);
    return done;
}

std::size_t PieceProxy::pread(void* to, std::size_t length, std::int64_t offset) {
    if (offset < 0 || static_cast<std::uint64_t>(offset) >= size_) return 0;
    auto at = static_cast<std::uint64_t>(offset);
    std::size_t done = 0;
    auto i =
        static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), at) - starts_.begin() - 1);
    for (; i < pieces_.size() && done < length; ++i) {
        const Piece& piece = pieces_[i];
        const std::uint64_t inside = at - starts_[i];
        const auto part =
            static_cast<std::size_t>(std::min<std::uint64_t>(length - done, piece.length - inside));
        char* const target = static_cast<char*>(to) + done;
        if (!piece.bytes.empty())
            std::memcpy(target, piece.bytes.data() + inside, part);
        else if (file_.read(piece.offset + inside, target, part) != part)
            break;
        done += part;
        at += part;
    }
    return done;
}

}  // namespace nacre
