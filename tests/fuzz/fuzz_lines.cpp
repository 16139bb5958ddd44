// Directions on standard input, as eval and tables read them: the first byte tells how many a line has.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>

#include "app/cli/direction_lines.h"
#include "tests/fuzz/target.h"

using namespace nacre;

namespace {

void bring(const std::uint8_t* data, std::size_t size) {
    static const int input = memfd_create("input", 0);
    fuzz::require(ftruncate(input, 0) == 0 && pwrite(input, data, size, 0) == static_cast<ssize_t>(size),
                  "the input is written");
    lseek(input, 0, SEEK_SET);
    dup2(input, STDIN_FILENO);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Interrupt interrupt("stopped\n");
    if (size == 0) return -1;
    bring(data + 1, size - 1);
    fuzz::reads([&] {
        cli::answer_lines(
            {.directions = 1 + data[0] % 2},
            [](std::span<const glm::dvec3> directions, std::string&) {
                for (const glm::dvec3& k : directions) {
                    const double square = k.x * k.x + k.y * k.y + k.z * k.z;
                    fuzz::require(std::fabs(square - 1) < 1e-12, "a direction has length 1");
                }
            },
            interrupt);
    });
    return 0;
}
