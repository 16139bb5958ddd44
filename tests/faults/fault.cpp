// Stands before libc's calls on files. As a preloaded library it is told by the environment:
// NACRE_FAULT="CALL NUMBER ERROR" and NACRE_FAULT_FOLDER.
#include "tests/faults/fault.h"

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>

namespace {

std::mutex guard;
nacre::test::Fault present;
std::atomic<bool> armed = false;
int met = 0;

bool lies_in_folder(std::string_view path) {
    return path.starts_with(present.folder) &&
           (path.size() == present.folder.size() || path[present.folder.size()] == '/');
}

std::string path_of(int descriptor) {
    char target[PATH_MAX];
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const ssize_t length = ::readlink(link.c_str(), target, sizeof target);
    return length > 0 ? std::string(target, static_cast<std::size_t>(length)) : std::string();
}

std::string path_of(int folder, const char* name) {
    return name[0] == '/' || folder == AT_FDCWD ? std::string(name) : path_of(folder) + "/" + name;
}

// Whether this is the one. Its errno is set.
bool fails(const char* call, const std::string& path) {
    const std::lock_guard lock(guard);
    if (!armed || present.call != call || !lies_in_folder(path) || ++met != present.number) return false;
    errno = present.error;
    return true;
}

template <class Path>
bool fails_if_armed(const char* call, const Path& path) {
    return armed && fails(call, path());
}

template <class Call>
Call* next(const char* name) {
    return reinterpret_cast<Call*>(dlsym(RTLD_NEXT, name));
}

mode_t mode_argument(int flags, va_list arguments) {
    return (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
}

struct FromEnvironment {
    FromEnvironment() {
        const char *fault = std::getenv("NACRE_FAULT"), *folder = std::getenv("NACRE_FAULT_FOLDER");
        if (fault == nullptr || folder == nullptr) return;
        char call[32] = {};
        nacre::test::Fault wanted;
        wanted.folder = folder;
        if (std::sscanf(fault, "%31s %d %d", call, &wanted.number, &wanted.error) != 3) std::abort();
        wanted.call = call;
        nacre::test::begin_fault(wanted);
    }
};

}  // namespace

namespace nacre::test {

void begin_fault(const Fault& fault) {
    const std::lock_guard lock(guard);
    present = fault;
    met = 0;
    armed = true;
}

bool end_fault() {
    const std::lock_guard lock(guard);
    armed = false;
    return met >= present.number;
}

std::vector<std::string> fault_calls() {
    return {"open",   "write",     "fsync", "fchmod", "fchown", "fstat",   "stat",  "flock",
            "rename", "renameat2", "link",  "unlink", "mkdir",  "opendir", "close", "access"};
}

}  // namespace nacre::test

namespace {
const FromEnvironment from_environment;
}

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_argument(flags, arguments);
    va_end(arguments);
    if (fails_if_armed("open", [&] { return std::string(path); })) return -1;
    return next<int(const char*, int, ...)>("open")(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_argument(flags, arguments);
    va_end(arguments);
    if (fails_if_armed("open", [&] { return std::string(path); })) return -1;
    return next<int(const char*, int, ...)>("open64")(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_argument(flags, arguments);
    va_end(arguments);
    if (fails_if_armed("open", [&] { return path_of(folder, path); })) return -1;
    return next<int(int, const char*, int, ...)>("openat")(folder, path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t count) {
    if (fails_if_armed("write", [&] { return path_of(descriptor); })) {
        if (errno != 0) return -1;
        count = (count + 1) / 2;
    }
    return next<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, count);
}

int fsync(int descriptor) {
    if (fails_if_armed("fsync", [&] { return path_of(descriptor); })) return -1;
    if (armed) return 0;  // the power stays on, and waiting for the disk takes long
    return next<int(int)>("fsync")(descriptor);
}

int fchmod(int descriptor, mode_t mode) noexcept {
    if (fails_if_armed("fchmod", [&] { return path_of(descriptor); })) return -1;
    return next<int(int, mode_t)>("fchmod")(descriptor, mode);
}

int fchown(int descriptor, uid_t user, gid_t group) noexcept {
    if (fails_if_armed("fchown", [&] { return path_of(descriptor); })) return -1;
    return next<int(int, uid_t, gid_t)>("fchown")(descriptor, user, group);
}

int fstat(int descriptor, struct stat* status) noexcept {
    if (fails_if_armed("fstat", [&] { return path_of(descriptor); })) return -1;
    return next<int(int, struct stat*)>("fstat")(descriptor, status);
}

int stat(const char* path, struct stat* status) noexcept {
    if (fails_if_armed("stat", [&] { return std::string(path); })) return -1;
    return next<int(const char*, struct stat*)>("stat")(path, status);
}

int lstat(const char* path, struct stat* status) noexcept {
    if (fails_if_armed("stat", [&] { return std::string(path); })) return -1;
    return next<int(const char*, struct stat*)>("lstat")(path, status);
}

int access(const char* path, int mode) noexcept {
    if (fails_if_armed("access", [&] { return std::string(path); })) return -1;
    return next<int(const char*, int)>("access")(path, mode);
}

int flock(int descriptor, int operation) noexcept {
    if (fails_if_armed("flock", [&] { return path_of(descriptor); })) return -1;
    return next<int(int, int)>("flock")(descriptor, operation);
}

int rename(const char* from, const char* to) noexcept {
    if (fails_if_armed("rename", [&] { return std::string(from); })) return -1;
    return next<int(const char*, const char*)>("rename")(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) noexcept {
    if (fails_if_armed("renameat2", [&] { return path_of(from_folder, from); })) return -1;
    return next<int(int, const char*, int, const char*, unsigned)>("renameat2")(from_folder, from, to_folder,
                                                                                to, flags);
}

int link(const char* from, const char* to) noexcept {
    if (fails_if_armed("link", [&] { return std::string(from); })) return -1;
    return next<int(const char*, const char*)>("link")(from, to);
}

int unlink(const char* path) noexcept {
    if (fails_if_armed("unlink", [&] { return std::string(path); })) return -1;
    return next<int(const char*)>("unlink")(path);
}

int unlinkat(int folder, const char* path, int flags) noexcept {
    if (fails_if_armed("unlink", [&] { return path_of(folder, path); })) return -1;
    return next<int(int, const char*, int)>("unlinkat")(folder, path, flags);
}

int mkdir(const char* path, mode_t mode) noexcept {
    if (fails_if_armed("mkdir", [&] { return std::string(path); })) return -1;
    return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

DIR* opendir(const char* path) {
    if (fails_if_armed("opendir", [&] { return std::string(path); })) return nullptr;
    return next<DIR*(const char*)>("opendir")(path);
}

// Linux closes it all the same.
int close(int descriptor) {
    const bool failing = fails_if_armed("close", [&] { return path_of(descriptor); });
    const int error = errno;
    const int result = next<int(int)>("close")(descriptor);
    if (!failing) return result;
    errno = error;
    return -1;
}

}  // extern "C"
