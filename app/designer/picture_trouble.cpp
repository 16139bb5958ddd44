#include "app/designer/picture_trouble.h"

#include <cctype>
#include <system_error>

#include "core/base/error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

// Whether the error is of a picture, whose reader says what it found.
std::string found_in(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const UserError& refused) {
        if (!refused.file.empty()) return refused.found;
    } catch (...) {
    }
    return {};
}

std::string problem_of(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const UserError& refused) {
        return refused.found.empty() ? refused.problem : refused.problem + ": " + refused.found;
    } catch (...) {
        return problem_line();
    }
}

}  // namespace

std::string reason_of(const std::exception_ptr& error) {
    const std::string found = found_in(error);
    return found.empty() ? problem_of(error) : found;
}

std::string sentence(std::string text) {
    if (text.empty()) return text;
    // Not a file's name.
    const std::string word = text.substr(0, text.find_first_of(" ,:"));
    if (word.find_first_of("./") == word.npos)
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text.back() == '.' ? text : text + '.';
}

std::string picture_trouble(const fs::path& file, const std::exception_ptr& error) {
    const std::string name = "\u201c" + one_line(file.filename().string()) + "\u201d";
    const std::string where = "\n\n" + one_line(file.string());
    std::error_code unknown;
    if (fs::is_directory(file, unknown)) return name + " is a folder. Choose a picture in it." + where;
    return name + " cannot be used. " + sentence(reason_of(error)) + where;
}

}  // namespace nacre
