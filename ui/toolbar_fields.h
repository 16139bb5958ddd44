// Numbers and lists above the canvas: they have no label, what they show says what they are.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/paint/brush.h"
#include "ui/widgets.h"

namespace nacre::ui {

bool bar(const SliderSpec& spec, float width, double& value);

// Of a part from 0 to 1, in hundredths.
bool percent(const char* name, const char* format, const char* text, float width, double reset, double& part);

struct WholeRange {
    int least, most, reset;
};

void whole_number(const char* name, const char* format, const WholeRange& range, float width,
                  const char* text, int& number);

void choice(const char* name, int& index, const std::vector<std::string>& names, float width,
            const char* text);

std::vector<std::string> labels_of(std::span<const Choice> list);

// How what the brush and its like do combines with what is there.
void combine_choice(Brush& brush, const char* name, float width);

}  // namespace nacre::ui
