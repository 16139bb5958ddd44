// An event script.
#include <cmath>

#include "app/headless/event_script.h"
#include "tests/fuzz/target.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::reads([&] {
        for (const Event& event : parse_events(fuzz::text_of(data, size), "fuzz.events").events) {
            fuzz::require(event.line > 0, "an event has a line");
            if (const auto* move = std::get_if<events::Move>(&event.what))
                fuzz::require(std::isfinite(move->to.at.x) && std::isfinite(move->to.at.y),
                              "places are finite");
            if (const auto* wheel = std::get_if<events::Wheel>(&event.what))
                fuzz::require(std::isfinite(wheel->notches), "the wheel's way is finite");
        }
    });
    return 0;
}
