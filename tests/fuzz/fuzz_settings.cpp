// The designer's settings: what is read is written and read again to the same.
#include "app/designer/settings.h"
#include "tests/fuzz/target.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        const Settings settings = parse_settings(fuzz::text_of(data, size), "settings.json");
        fuzz::require(parse_settings(settings_text(settings), "again") == settings,
                      "settings that are written read back the same");
    });
    return 0;
}
