// Why a picture cannot be used, in words before paths.
#pragma once

#include <exception>
#include <filesystem>
#include <string>

namespace nacre {

// The reason alone, without a file or a place in one: "a PDF document, not a picture".
std::string reason_of(const std::exception_ptr& error);

// With a capital at its beginning and a full stop behind it.
std::string sentence(std::string text);

// What is wrong in a sentence or two, and below it where the file lies.
std::string picture_trouble(const std::filesystem::path& file, const std::exception_ptr& error);

}  // namespace nacre
