#include "core/base/system/output_guard.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>
#include <wctype.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cwchar>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "core/base/error.h"
#include "core/base/system/atomic_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

// The identity of a file; of a missing one, its folder and its name there.
struct Identity {
    dev_t device = 0;
    ino_t number = 0;
    std::string name;  // of a file that is not there

    auto operator<=>(const Identity&) const = default;
};

Identity identity_of(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0) return {status.st_dev, status.st_ino, {}};
    const fs::path target = link_target(file);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const std::string name = target.filename().string();
    if (::stat(folder.c_str(), &status) == 0)
        return {status.st_dev, status.st_ino, ignores_case(folder) ? without_case(name) : name};
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(target, error), error);
    return {0, 0, error ? target.lexically_normal().string() : whole.string()};
}

// ASCII letters alone: every file system that ignores case ignores theirs.
std::string with_case_swapped(std::string name) {
    for (char& c : name)
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) c = static_cast<char>(c ^ 0x20);
    return name;
}

bool is_listed(const fs::path& folder, const std::string& name) {
    std::error_code error;
    for (auto it = fs::directory_iterator(folder, error); !error && it != fs::directory_iterator();
         it.increment(error))
        if (it->path().filename() == name) return true;
    return false;
}

// Tested by a file in the folder: whether it is found under its name with the case swapped, though no such
// name is listed, as one of a second link is. Nothing where no name in it has letters.
std::optional<bool> finds_swapped(const fs::path& folder) {
    std::error_code error;
    for (auto it = fs::directory_iterator(folder, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
        const std::string name = it->path().filename().string(), swapped = with_case_swapped(name);
        struct stat own {
        }, other{};
        if (swapped == name || ::lstat(it->path().c_str(), &own) != 0) continue;
        if (::lstat((folder / swapped).c_str(), &other) != 0) {
            if (errno == ENOENT) return false;
            continue;
        }
        return own.st_dev == other.st_dev && own.st_ino == other.st_ino && !is_listed(folder, swapped);
    }
    return {};
}

}  // namespace

bool ignores_case(const fs::path& folder) {
    if (const auto found = finds_swapped(folder.empty() ? "." : folder)) return *found;
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return folder.has_relative_path() && ignores_case(folder.parent_path());
    int flags = 0;
    struct statfs system {};
    const bool folds = ::ioctl(descriptor, FS_IOC_GETFLAGS, &flags) == 0 && (flags & FS_CASEFOLD_FL) != 0;
    const bool known = ::fstatfs(descriptor, &system) == 0;
    ::close(descriptor);
    // FAT, exFAT, NTFS, CIFS, SMB and HFS+: see statfs(2).
    constexpr std::uint32_t types[] = {0x4d44,     0x2011bab0, 0x5346544e, 0x7366746e,
                                       0xff534d42, 0xfe534d42, 0x482b};
    return folds || (known && std::find(std::begin(types), std::end(types),
                                        static_cast<std::uint32_t>(system.f_type)) != std::end(types));
}

std::string without_case(const std::string& utf8) {
    static const locale_t unicode = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
    std::string folded;
    std::mbstate_t state{};
    const locale_t before = ::uselocale(unicode);
    for (std::size_t at = 0; at < utf8.size();) {
        wchar_t letter = 0;
        const std::size_t length = std::mbrtowc(&letter, utf8.data() + at, utf8.size() - at, &state);
        char bytes[MB_LEN_MAX];
        if (length == 0 || length > utf8.size()) {
            state = {};
            folded += utf8[at++];
            continue;
        }
        const std::size_t written =
            std::wcrtomb(bytes, static_cast<wchar_t>(std::towlower(static_cast<wint_t>(letter))), &state);
        folded.append(bytes, written);
        at += length;
    }
    ::uselocale(before);
    return folded;
}

void check_outputs(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
    std::map<Identity, fs::path> read, written;
    for (const fs::path& input : inputs) {
        std::error_code error;
        if (fs::is_regular_file(input, error)) read.emplace(identity_of(input), input);
    }
    for (const fs::path& output : outputs) {
        const Identity identity = identity_of(output);
        if (const auto found = read.find(identity); found != read.end())
            throw UserError(output.string(), "write",
                            "this would overwrite a file that is read for it; choose another name",
                            found->second.string());
        const auto [other, is_new] = written.emplace(identity, output);
        if (!is_new)
            throw UserError(output.string(), "write", "another output of the same command is the same file",
                            other->second.string());
    }
}

}  // namespace nacre
