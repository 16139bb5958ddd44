// The offer to go on with work that was not saved when the program ended.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nacre::ui {

struct RecoveryRow {
    std::string name;   // of the design
    std::string where;  // its file, or why it has none
    std::string when;   // of the last change
};

enum class RecoveryAnswer { restore, discard, later };

// Draws the dialog; the answer is about the chosen row. `problem` stands below the list.
std::optional<RecoveryAnswer> recovery_dialog(const std::vector<RecoveryRow>& rows, std::size_t& chosen,
                                              const std::string& problem);

}  // namespace nacre::ui
