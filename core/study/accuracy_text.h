// The report of error beside time as text: for spreadsheets, for programs and for people.
#pragma once

#include <string>
#include <vector>

#include "core/study/accuracy.h"

namespace nacre {

// One row for each point and quantity; RFC 4180, a header first.
std::string accuracy_csv(const std::vector<DesignAccuracy>& designs);

std::string accuracy_json(const std::vector<DesignAccuracy>& designs);

// Tables over all designs, then those of each design, with its charts of chart_file().
std::string accuracy_markdown(const std::vector<DesignAccuracy>& designs);

}  // namespace nacre
