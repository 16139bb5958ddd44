#include "core/base/system/atomic_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <deque>
#include <string>
#include <system_error>

#include "core/base/error.h"
#include "core/base/system/system_call.h"
#include "core/base/system/temporary_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr int numbers_max = 99'999;
constexpr int links_max = 40;  // as many as Linux follows

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
    throw UserError(file.string(), "write", "the file cannot be written", reason);
}

// Where the bytes go. Devices and pipes are refused, since a rename would replace the device itself.
fs::path final_target(const fs::path& file) {
    std::error_code error;
    fs::path target = link_target(file);
    const fs::file_status status = fs::status(target, error);
    if (status.type() == fs::file_type::none) fail(file, error.message());
    if (fs::is_directory(status) || !target.has_filename()) fail(file, "it is a directory");
    if (!fs::exists(status)) return target;
    if (!fs::is_regular_file(status)) fail(file, "it is not a regular file");
    if (::access(target.c_str(), W_OK) != 0) fail_to_write(file, errno);
    return target;
}

// Renames of one kind or other that a file system has not.
bool is_unknown_to_system(int error) { return error == EINVAL || error == ENOSYS || error == EOPNOTSUPP; }

bool rename_file(const fs::path& from, const fs::path& to) {
    return uninterrupted([&] { return std::rename(from.c_str(), to.c_str()); }) == 0;
}

bool exchange_files(const fs::path& one, const fs::path& other) {
    return uninterrupted([&] {
               return ::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE);
           }) == 0;
}

// So that the new name outlives a power cut. Some file systems cannot, and the file is whole without it.
void synchronise_folder(const fs::path& folder) {
    const Descriptor opened(uninterrupted(
        [&] { return ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
    if (opened.number >= 0) uninterrupted([&] { return ::fsync(opened.number); });
}

void become_target(TemporaryFile& written) {
    if (!rename_file(written.path(), written.target())) fail_to_write(written.file(), errno);
    written.release();
    synchronise_folder(written.target().parent_path());
}

// Files that have got their names, for as long as it is not sure that all will: until then what stood there
// before lies under the temporary name, and comes back unless keep() is called.
class Replacement {
  public:
    Replacement() = default;
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;
    ~Replacement() {
        bool whole = true;
        for (auto step = steps_.rbegin(); step != steps_.rend() && whole; ++step) whole = undo(*step);
        if (!whole && !aside_.empty()) ::unlink(aside_.c_str());
    }

    void put(const TemporaryFile& written) {
        const fs::path &from = written.path(), &to = written.target();
        if (exchange_files(from, to)) {
            steps_.push_back({from, to, Way::exchanged});
            return;
        }
        // The target is not there, or the file system has no exchange: then there is no way back.
        const bool is_new = errno == ENOENT;
        if (!is_new && !is_unknown_to_system(errno)) fail_to_write(written.file(), errno);
        if (!rename_file(from, to)) fail_to_write(written.file(), errno);
        steps_.push_back({from, to, is_new ? Way::moved : Way::lost});
    }

    // Nothing where `file` is not there.
    void take_away(const fs::path& file, const fs::path& target) {
        aside_ = temporary_name(target.parent_path());
        if (rename_file(target, aside_))
            steps_.push_back({target, aside_, Way::moved});
        else if (errno != ENOENT)
            fail_to_write(file, errno);
    }

    void keep() {
        steps_.clear();
        if (!aside_.empty()) ::unlink(aside_.c_str());
    }

  private:
    enum class Way { exchanged, moved, lost };
    struct Step {
        fs::path from, to;
        Way way;
    };

    static bool undo(const Step& step) {
        if (step.way == Way::lost) return false;
        return step.way == Way::exchanged ? exchange_files(step.from, step.to)
                                          : rename_file(step.to, step.from);
    }

    std::vector<Step> steps_;
    fs::path aside_;
};

}  // namespace

fs::path link_target(const fs::path& file) {
    fs::path target = file;
    for (int links = 0; links <= links_max; ++links) {
        std::error_code error;
        const fs::file_status status = fs::symlink_status(target, error);
        if (status.type() == fs::file_type::none) fail(file, error.message());
        if (!fs::is_symlink(status)) return target;
        const fs::path next = fs::read_symlink(target, error);
        if (error) fail(file, error.message());
        target = target.parent_path() / next;
    }
    fail_to_write(file, ELOOP);
}

void write_file_atomically(const fs::path& file, std::string_view bytes) {
    const fs::path target = final_target(file);
    sweep_temporary_files(target.parent_path());
    TemporaryFile temporary(file, target);
    temporary.write(bytes);
    become_target(temporary);
}

void write_files_atomically(const std::vector<FileToWrite>& files) {
    if (files.empty()) return;
    std::deque<TemporaryFile> written;
    for (const FileToWrite& each : files) {
        const fs::path target = final_target(each.file);
        if (written.empty() || written.back().target().parent_path() != target.parent_path())
            sweep_temporary_files(target.parent_path());
        written.emplace_back(each.file, target).write(each.bytes);
    }
    TemporaryFile& last = written.back();
    Replacement replacement;
    if (written.size() > 1) replacement.take_away(last.file(), last.target());
    for (const TemporaryFile& each : written)
        if (&each != &last) replacement.put(each);
    synchronise_folder(last.target().parent_path());
    become_target(last);
    replacement.keep();
}

fs::path write_numbered_file(const fs::path& folder, const std::string& stem, const std::string& extension,
                             std::string_view bytes) {
    const fs::path pattern = folder / (stem + extension);
    sweep_temporary_files(folder);
    TemporaryFile temporary(pattern, folder / "");
    temporary.write(bytes);
    for (int number = 1; number <= numbers_max; ++number) {
        fs::path name = folder / fmt::format("{}-{:03}{}", stem, number, extension);
        std::error_code error;
        if (fs::exists(fs::symlink_status(name, error))) continue;
        if (rename_if_free(temporary.path(), name)) {
            temporary.release();
            synchronise_folder(folder);
            return name;
        }
        const int reason = errno;
        if (!fs::exists(fs::symlink_status(name, error))) fail_to_write(name, reason);
    }
    fail(pattern, "every number has been taken");
}

bool rename_if_free(const fs::path& from, const fs::path& to) {
    const auto renamed = uninterrupted(
        [&] { return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE); });
    if (renamed == 0) return true;
    // Where the file system has no such renaming, a second link does it as well.
    if (!is_unknown_to_system(errno)) return false;
    if (uninterrupted([&] { return ::link(from.c_str(), to.c_str()); }) != 0) return false;
    ::unlink(from.c_str());
    return true;
}

}  // namespace nacre
