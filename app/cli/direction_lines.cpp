#include "app/cli/direction_lines.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "app/cli/line_source.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "core/base/error.h"

namespace nacre::cli {
namespace {

constexpr std::string_view blanks = " \t\v\f";
constexpr int directions_max = 2;
constexpr std::size_t chunks = 256;  // of a batch, for parallel work

using Directions = std::array<glm::dvec3, directions_max>;

[[noreturn]] void fail(const InputLine& line, const std::string& problem) {
    throw UserError("standard input", fmt::format("line {}", line.number), problem,
                    line.text.empty() ? "" : one_line(line.text, 100));
}

// A decimal number, rounded to 0 where it is too small; nothing for what is not a finite number.
std::optional<double> parse_number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(text).c_str(), nullptr);
    if (!std::isfinite(value)) return {};
    return value;
}

Directions parse_line(const InputLine& line, int directions) {
    const int wanted = 3 * directions;
    Directions result{};
    int count = 0;
    std::string_view rest = line.text;
    for (;;) {
        rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
        if (rest.empty()) break;
        const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
        rest.remove_prefix(word.size());
        const std::optional<double> value = parse_number(word);
        if (count == wanted || !value) fail(line, fmt::format("must be {} finite numbers", wanted));
        result[static_cast<std::size_t>(count / 3)][count % 3] = *value;
        ++count;
    }
    if (count != wanted) fail(line, fmt::format("must be {} finite numbers", wanted));
    for (int i = 0; i < directions; ++i) {
        glm::dvec3& v = result[static_cast<std::size_t>(i)];
        if (v == glm::dvec3{0}) fail(line, "a zero vector is no direction");
        v = normalised(v);
    }
    return result;
}

bool is_skipped(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos || text[first] == '#';
}

// Answers to consecutive lines, up to the first that is wrong.
struct Chunk {
    std::string text;
    std::optional<UserError> error;
};

Chunk answer_chunk(std::span<const InputLine> lines, int directions, const Answer& answer,
                   const Interrupt& interrupt) {
    Chunk chunk;
    try {
        for (const InputLine& line : lines) {
            interrupt.check();
            if (is_skipped(line.text)) continue;
            const Directions parsed = parse_line(line, directions);
            answer(std::span(parsed).first(static_cast<std::size_t>(directions)), chunk.text);
        }
    } catch (const UserError& error) {
        chunk.error = error;
    }
    return chunk;
}

}  // namespace

glm::dvec3 normalised(glm::dvec3 v) {
    const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    const int exponent = std::ilogb(largest);
    for (int i = 0; i < 3; ++i) v[i] = std::scalbn(v[i], -exponent);
    return v / glm::length(v);
}

void answer_lines(const LineOptions& options, const Answer& answer, const Interrupt& interrupt) {
    LineSource source(interrupt);
    Progress progress("answering");
    std::vector<Chunk> answers;
    for (;;) {
        const std::span<const InputLine> lines = source.next(static_cast<std::size_t>(options.batch));
        if (lines.empty()) return;
        const std::size_t size = (lines.size() + chunks - 1) / chunks;
        answers.assign((lines.size() + size - 1) / size, {});
        tbb::parallel_for(std::size_t{0}, answers.size(), [&](std::size_t i) {
            const std::size_t begin = i * size;
            answers[i] = answer_chunk(lines.subspan(begin, std::min(size, lines.size() - begin)),
                                      options.directions, answer, interrupt);
        });
        std::string text;
        for (const Chunk& chunk : answers) {
            text += chunk.text;
            if (!chunk.error) continue;
            write_output(text);
            throw UserError(*chunk.error);
        }
        write_output(text);
        if (!output_is_terminal()) progress.report(source.done());
    }
}

}  // namespace nacre::cli
