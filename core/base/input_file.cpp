#include "core/base/input_file.h"

#include <fmt/core.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

namespace nacre {

namespace fs = std::filesystem;

std::string input_file_problem(const fs::path& file, std::uintmax_t bytes_max) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (error) return error.message();
    if (fs::is_directory(status)) return "a directory, not a file";
    if (!fs::is_regular_file(status)) return "not a regular file";
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) return error.message();
    if (size > bytes_max) return fmt::format("{} bytes, more than the {} that are read", size, bytes_max);
    errno = 0;
    if (!std::ifstream(file)) return std::generic_category().message(errno);
    return {};
}

std::string read_text_file(const fs::path& file, std::uintmax_t bytes_max) {
    if (const std::string problem = input_file_problem(file, bytes_max); !problem.empty())
        throw UserError(file.string(), "open", "the file cannot be read", problem);
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    std::string text(error ? 0 : size, '\0');
    std::ifstream stream(file, std::ios::binary);
    errno = 0;
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (error || stream.bad() || static_cast<std::size_t>(stream.gcount()) != text.size())
        throw UserError(file.string(), "read", "the file cannot be read",
                        error ? error.message() : std::generic_category().message(errno));
    return text;
}

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    return text;
}

std::string read_first_line(const fs::path& file, std::uintmax_t bytes_max) {
    if (const std::string problem = input_file_problem(file, bytes_max); !problem.empty())
        throw UserError(file.string(), "open", "the file cannot be read", problem);
    std::ifstream stream(file, std::ios::binary);
    std::string line;
    std::getline(stream, line);
    if (stream.bad())
        throw UserError(file.string(), "read", "the file cannot be read",
                        std::generic_category().message(errno));
    return line;
}

fs::path absolute_folder(const fs::path& folder) {
    std::error_code error;
    const fs::path absolute = fs::absolute(folder.empty() ? fs::path(".") : folder, error);
    const fs::path canonical = fs::weakly_canonical(absolute, error);
    return error ? absolute.lexically_normal() : canonical;
}

}  // namespace nacre
