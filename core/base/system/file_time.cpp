#include "core/base/system/file_time.h"

#include <sys/stat.h>

#include <ctime>

namespace nacre {

constexpr std::int64_t second = 1'000'000'000;

std::optional<std::int64_t> time_written(const std::filesystem::path& file) {
    struct stat status {};
    if (::lstat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    return status.st_mtim.tv_sec * second + status.st_mtim.tv_nsec;
}

std::string local_time(std::int64_t nanoseconds) {
    const std::time_t seconds = nanoseconds / second;
    std::tm parts{};
    localtime_r(&seconds, &parts);
    char text[64];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts)};
}

}  // namespace nacre
