#include "app/cli/verbs.h"

#include <array>

namespace nacre::cli {

std::span<const Verb* const> verbs() {
    static const std::array list{
#define VERB(name) &name##_verb,
#include "app/cli/verb_list.inc"
#undef VERB
    };
    return list;
}

}  // namespace nacre::cli
