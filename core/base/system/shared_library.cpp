#include "core/base/system/shared_library.h"

#include <dlfcn.h>

#include <stdexcept>

namespace nacre {

std::filesystem::path program_folder() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

void* symbol_of_library(const std::filesystem::path& library, const char* name) {
    void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (loaded == nullptr) throw std::runtime_error(dlerror());
    void* const symbol = dlsym(loaded, name);
    if (symbol == nullptr) throw std::runtime_error(dlerror());
    return symbol;
}

}  // namespace nacre
