// A design file: what is read is written and read again to the same design.
#include "core/design/design_file.h"
#include "tests/fuzz/target.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = fuzz::text_of(data, size), folder = "/nonexistent";
    fuzz::reads([&] {
        const Design design = parse_work(text, "fuzz.nacre", folder);
        const std::string written = design_json(design, folder);
        const Design again = parse_work(written, "again.nacre", folder);
        fuzz::require(again == design, "a design that is written reads back the same");
        fuzz::require(design_json(again, folder) == written, "and is written the same");
    });
    return 0;
}
