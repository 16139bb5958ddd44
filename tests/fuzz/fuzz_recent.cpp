// The list of recent files.
#include "app/designer/recent_files.h"
#include "tests/fuzz/target.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        for (const auto& file : parse_recent(fuzz::text_of(data, size), "recent.json"))
            fuzz::require(file.native().find('\0') == std::string::npos, "a path has no NUL");
    });
    return 0;
}
