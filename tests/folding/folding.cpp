#include "tests/folding/folding.h"

#include <dirent.h>
#include <dlfcn.h>
#include <linux/fs.h>
#include <strings.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <climits>
#include <cstdarg>

namespace {

nacre::test::Folding present;

template <class Call>
Call* next(const char* name) {
    return reinterpret_cast<Call*>(dlsym(RTLD_NEXT, name));
}

bool is_the_folder(int descriptor) {
    char target[PATH_MAX];
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const ssize_t length = ::readlink(link.c_str(), target, sizeof target);
    return length > 0 && std::string(target, static_cast<std::size_t>(length)) == present.folder;
}

// The name as the folder lists it, of a path right below it.
std::string as_listed(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (!present.folds || slash == std::string::npos || path.substr(0, slash) != present.folder) return path;
    std::string found = path;
    DIR* const entries = ::opendir(present.folder.c_str());
    while (const dirent* const entry = entries != nullptr ? ::readdir(entries) : nullptr)
        if (::strcasecmp(entry->d_name, path.c_str() + slash + 1) == 0)
            found = present.folder + "/" + entry->d_name;
    if (entries != nullptr) ::closedir(entries);
    return found;
}

}  // namespace

namespace nacre::test {

FoldingFolder::FoldingFolder(const Folding& folding) { present = folding; }

FoldingFolder::~FoldingFolder() { present = Folding{.folder = {}, .folds = false}; }

}  // namespace nacre::test

extern "C" {

int stat(const char* path, struct stat* status) noexcept {
    return next<int(const char*, struct stat*)>("stat")(as_listed(path).c_str(), status);
}

int lstat(const char* path, struct stat* status) noexcept {
    return next<int(const char*, struct stat*)>("lstat")(as_listed(path).c_str(), status);
}

int fstatfs(int descriptor, struct statfs* status) noexcept {
    const int result = next<int(int, struct statfs*)>("fstatfs")(descriptor, status);
    if (result == 0 && present.system_type != 0 && is_the_folder(descriptor))
        status->f_type = present.system_type;
    return result;
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
    va_list arguments;
    va_start(arguments, request);
    void* const argument = va_arg(arguments, void*);
    va_end(arguments);
    const int result = next<int(int, unsigned long, void*)>("ioctl")(descriptor, request, argument);
    if (request != FS_IOC_GETFLAGS || !present.has_flag || !is_the_folder(descriptor)) return result;
    *static_cast<int*>(argument) = FS_CASEFOLD_FL;
    return 0;
}

}  // extern "C"
