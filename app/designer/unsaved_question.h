// What is asked before work that is not saved would be lost.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace nacre {

enum class UnsavedAnswer { keep, discard, cancel };

// Of the design that is edited: to keep it is to save it.
std::optional<UnsavedAnswer> ask_about_unsaved(const std::string& name);

// Of one that a preset took the place of: to keep it is to bring it back.
std::optional<UnsavedAnswer> ask_about_unsaved_elsewhere(const std::vector<std::string>& names);

}  // namespace nacre
