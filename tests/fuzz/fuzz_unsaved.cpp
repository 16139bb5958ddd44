// Unsaved work: a line about it, then a design.
#include "app/designer/autosave.h"
#include "tests/fuzz/target.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        const UnsavedWork work = parse_autosave(fuzz::text_of(data, size), "/nonexistent/unsaved.nacre");
        fuzz::require(work.file.empty() || work.file.is_absolute(), "the document's path is absolute");
    });
    return 0;
}
