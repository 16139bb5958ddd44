// Directions on standard input, a line each, and the answers to them in the same order.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "core/base/system/interrupt.h"

namespace nacre::cli {

// The direction with length 1. Any size but 0 will do: the scaling neither overflows nor underflows.
glm::dvec3 normalised(glm::dvec3 v);

struct LineOptions {
    int directions = 1;  // on a line
    int batch = 65536;   // lines that are answered together, in parallel
};

// Appends the answer, its end of line included, to the text.
using Answer = std::function<void(std::span<const glm::dvec3> directions, std::string& text)>;

// Lines that are blank or begin with # are skipped. What is not as many finite numbers as it must be, or a
// zero vector, is a UserError at its line, after the answers to the lines before it.
void answer_lines(const LineOptions& options, const Answer& answer, const Interrupt& interrupt);

}  // namespace nacre::cli
