// Names of files that may be no UTF-8.
#include "core/base/utf8.h"

#include <doctest/doctest.h>

#include <string>

using namespace nacre;

TEST_CASE("utf8: each byte that is no text becomes the replacement character, and the rest stays") {
    CHECK(as_utf8("").empty());
    CHECK(as_utf8("satin \u6f06 \U0001F3A8 \u00e9") == "satin \u6f06 \U0001F3A8 \u00e9");
    CHECK(as_utf8("s\xe9mi.nacre") == "s\uFFFDmi.nacre");  // Latin-1
    CHECK(as_utf8("\xff\xfe") == "\uFFFD\uFFFD");
    CHECK(as_utf8("a\xe6\xbc") == "a\uFFFD\uFFFD");          // cut short
    CHECK(as_utf8("\xc0\xaf") == "\uFFFD\uFFFD");            // longer than need be
    CHECK(as_utf8("\xed\xa0\x80") == "\uFFFD\uFFFD\uFFFD");  // half of a pair of UTF-16
    CHECK(as_utf8("\xf4\x90\x80\x80").size() == 12);         // beyond U+10FFFF
    CHECK(as_utf8(std::string("a\0b", 3)) == std::string("a\0b", 3));
}
