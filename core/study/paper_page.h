// The parts of the paper as one page of HTML.
#pragma once

#include <string>
#include <vector>

#include "core/study/paper.h"

namespace nacre {

struct MadePart {
    const PaperPart* part;
    PaperResult result;
};

// Its pictures are looked for beside it.
std::string paper_page(const std::vector<MadePart>& parts);

}  // namespace nacre
