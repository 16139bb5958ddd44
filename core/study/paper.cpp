#include "core/study/paper.h"

namespace nacre {
namespace {

constexpr const PaperPart* parts[] = {
#define PART(name) &name##_part,
#include "core/study/paper_list.inc"
#undef PART
};

}  // namespace

std::span<const PaperPart* const> paper_parts() { return parts; }

}  // namespace nacre
