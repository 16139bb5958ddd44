#include "core/paint/select_tool.h"

#include <array>

namespace nacre {

const SelectToolInfo& info(SelectTool tool) {
    static constexpr std::array list{
#define SELECT(name) &select_##name##_tool,
#include "core/paint/select_list.inc"
#undef SELECT
    };
    return *list[static_cast<std::size_t>(tool)];
}

}  // namespace nacre
