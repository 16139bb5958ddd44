#include "core/base/xml_text.h"

#include "core/base/error.h"

namespace nacre {

std::string xml_text(const std::string& utf8) {
    std::string text;
    for (const char c : one_line(utf8)) {
        switch (c) {
            case '&':
                text += "&amp;";
                break;
            case '<':
                text += "&lt;";
                break;
            case '>':
                text += "&gt;";
                break;
            case '"':
                text += "&quot;";
                break;
            default:
                text += c;
        }
    }
    // Two code points that UTF-8 can hold and XML cannot.
    for (const char* forbidden : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
        for (std::size_t at = 0; (at = text.find(forbidden, at)) != text.npos;) text.replace(at, 3, "?");
    return text;
}

}  // namespace nacre
