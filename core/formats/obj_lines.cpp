#include "core/formats/obj_lines.h"

#include <algorithm>
#include <array>

namespace nacre {
namespace {

constexpr std::string_view blanks = " \t\v\f";

// Where the line's comment begins, or npos. Some programs write a NaN as 1.#QNAN, which must not become 1.
std::size_t comment_begin(std::string_view line) {
    std::size_t at = line.find('#');
    while (at != std::string_view::npos && at > 0 && line[at - 1] == '.') at = line.find('#', at + 1);
    return at;
}

}  // namespace

std::string_view ObjLines::take_line() {
    ++line_;
    const std::size_t end = rest_.find_first_of("\r\n");
    const std::string_view line = rest_.substr(0, end);
    if (end == std::string_view::npos)
        rest_ = {};
    else
        rest_.remove_prefix(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
    return line;
}

// Whether the statement goes on. Blanks behind the backslash are not seen in an editor, and do not count.
bool ObjLines::add_words(std::string_view line, std::size_t number, std::vector<ObjWord>& words) {
    const std::size_t comment = comment_begin(line);
    line = line.substr(0, comment);
    const std::size_t last = line.find_last_not_of(blanks);
    const bool goes_on =
        comment == std::string_view::npos && last != std::string_view::npos && line[last] == '\\';
    if (goes_on) line = line.substr(0, last);
    std::size_t begin = line.find_first_not_of(blanks);
    while (begin != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
        words.push_back({line.substr(begin, end - begin), number});
        begin = line.find_first_not_of(blanks, end);
    }
    return goes_on;
}

bool ObjLines::next(std::vector<ObjWord>& words) {
    words.clear();
    bool goes_on = true;
    while (!rest_.empty() && (goes_on || words.empty())) {
        const std::string_view line = take_line();
        goes_on = add_words(line, line_, words);
    }
    return !words.empty();
}

std::string_view wide_encoding(std::string_view text) {
    using namespace std::string_view_literals;
    if (text.starts_with("\xff\xfe\0\0"sv) || text.starts_with("\0\0\xfe\xff"sv)) return "UTF-32";
    if (text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv)) return "UTF-16";
    // Without a byte order mark: characters of ASCII leave the same bytes of every unit zero.
    const std::string_view begin = text.substr(0, 1024);
    std::array<std::size_t, 4> zeros{};
    for (std::size_t i = 0; i < begin.size(); ++i)
        if (begin[i] == '\0') ++zeros[i % 4];
    const std::size_t units = begin.size() / 4;
    const auto mostly = [&](std::size_t i) { return units > 0 && zeros[i] > units * 3 / 4; };
    if ((mostly(0) && mostly(1)) || (mostly(2) && mostly(3))) return "UTF-32";
    if ((mostly(0) && mostly(2)) || (mostly(1) && mostly(3))) return "UTF-16";
    return {};
}

}  // namespace nacre
