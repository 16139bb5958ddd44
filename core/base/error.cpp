#include "core/base/error.h"

#include <fmt/core.h>

#include <cstdint>
#include <new>
#include <system_error>
#include <utility>

#include "core/base/utf8.h"

namespace nacre {
namespace {

constexpr std::size_t where_max = 160;
constexpr std::size_t problem_max = 600;
constexpr std::size_t found_max = 200;

// Control characters, line and paragraph separators, and the marks that reorder text on a terminal.
bool moves_the_cursor(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

std::string escape(std::uint32_t code) {
    if (code == '\n') return "\\n";
    if (code == '\t') return "\\t";
    if (code == '\r') return "\\r";
    return fmt::format("\\u{:04x}", code);
}

std::string compose(const std::string& file, const std::string& where, const std::string& problem,
                    const std::string& found) {
    const std::string line =
        one_line(file) + ": " + one_line(where, where_max) + ": " + one_line(problem, problem_max);
    return found.empty() ? line : line + " (" + one_line(found, found_max) + ")";
}

}  // namespace

UserError::UserError(std::string in_file, std::string at, std::string wrong, std::string seen)
    : std::runtime_error(compose(in_file, at, wrong, seen)),
      file(std::move(in_file)),
      where(std::move(at)),
      problem(std::move(wrong)),
      found(std::move(seen)) {}

std::string plain_words(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const UserError& refused) {
        const std::string where = refused.where.empty() ? "" : refused.where + ": ";
        return where + refused.problem + (refused.found.empty() ? "" : " (" + refused.found + ")");
    } catch (...) {
        return problem_line();
    }
}

std::string problem_line(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        return "there is not enough memory for this";
    } catch (const std::system_error& other) {
        const bool no_thread = other.code() == std::errc::resource_unavailable_try_again;
        return no_thread ? "there is not enough memory for this: no thread can be started"
                         : one_line(other.what());
    } catch (const std::exception& other) {
        return one_line(other.what());
    } catch (...) {
        return "an unknown error";
    }
}

std::string one_line(std::string_view text, std::size_t length_max) {
    std::string line;
    for (std::size_t characters = 0; !text.empty(); ++characters) {
        if (characters == length_max) return line + "...";
        const CodePoint code = decode_utf8(text);
        if (code.length == 0)
            line += fmt::format("\\x{:02x}", code.value);
        else if (moves_the_cursor(code.value))
            line += escape(code.value);
        else
            line += text.substr(0, code.length);
        text.remove_prefix(code.length == 0 ? 1 : code.length);
    }
    return line;
}

}  // namespace nacre
