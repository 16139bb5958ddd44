// TIFF files of either byte order and offset size, with any number of fields that make no pixels, and with
// fields that claim more than the file has.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/image/picture.h"
#include "tests/core/picture_files.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/user_error_of.h"

using namespace nacre;
using namespace nacre::test;

namespace {

enum Type : unsigned { byte = 1, ascii = 2, shorts = 3, longs = 4 };

struct Field {
    unsigned tag, type;
    std::uint64_t count;
    std::string data;  // as it is stored
};

// The quarters in one strip of 8 bit colours.
struct Tiff {
    bool little = true, large = false;  // BigTIFF
    std::vector<Field> more = {};

    std::string number(std::uint64_t value, std::size_t length) const {
        std::string bytes;
        for (std::size_t i = 0; i < length; ++i)
            bytes += static_cast<char>(value >> (8 * (little ? i : length - 1 - i)));
        return bytes;
    }
    std::string bytes() const {
        const FloatImage image = quarters();
        const std::size_t offset_size = large ? 8 : 4, start = large ? 16 : 8;
        std::string data;
        for (const float value : image.values) data += static_cast<char>(std::lround(255 * value));
        const std::size_t pixels = data.size();
        const auto one = [&](unsigned tag, std::uint64_t value) {
            return Field{tag, longs, 1, number(value, 4)};
        };
        std::vector<Field> fields{
            one(256, 64), one(257, 32), {258, shorts, 3, number(8, 2) + number(8, 2) + number(8, 2)},
            one(259, 1),  one(262, 2),  one(273, start),
            one(277, 3),  one(278, 32), one(279, pixels)};
        fields.insert(fields.end(), more.begin(), more.end());
        std::stable_sort(fields.begin(), fields.end(),
                         [](const Field& a, const Field& b) { return a.tag < b.tag; });
        std::string directory = number(fields.size(), large ? 8 : 2);
        for (const Field& field : fields) {
            directory += number(field.tag, 2) + number(field.type, 2) + number(field.count, offset_size);
            std::string value = field.data;
            if (value.size() > offset_size) {
                data += value;
                value = number(start + data.size() - value.size(), offset_size);
            }
            directory += value + std::string(offset_size - value.size(), '\0');
        }
        const std::string version = large ? number(43, 2) + number(8, 2) + number(0, 2) : number(42, 2);
        return (little ? "II" : "MM") + version + number(start + data.size(), offset_size) + data +
               directory + std::string(offset_size, '\0');
    }
};

Field text(unsigned tag, const std::string& data) { return {tag, byte, data.size(), data}; }

std::string xmp(const std::string& inside) {
    return "<x:xmpmeta xmlns:x='adobe:ns:meta/'><rdf:RDF><rdf:Description>" + inside +
           "</rdf:Description></rdf:RDF></x:xmpmeta>";
}

struct Read {
    const TemporaryFolder folder;
    std::vector<glm::vec3> operator()(const Tiff& tiff) {
        write_all(folder / "a.tif", tiff.bytes());
        return load_colours(folder / "a.tif").colours;
    }
    std::string refusal(const std::string& bytes) {
        write_all(folder / "bad.tif", bytes);
        return user_error_of([&] { load_colours(folder / "bad.tif"); });
    }
};

bool has(const std::string& line, const char* part) { return line.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE_BEGIN("tiff picture");

TEST_CASE("tiff picture: both byte orders, and offsets of 64 bits") {
    Read read;
    const std::vector<glm::vec3> plain = read({});
    REQUIRE(plain.size() == 64 * 32);
    CHECK(plain[0] == glm::vec3(1, 0, 0));
    CHECK(plain.back() == glm::vec3(1));
    for (const bool little : {true, false})
        for (const bool large : {true, false}) CHECK(read({.little = little, .large = large}) == plain);
}

TEST_CASE("tiff picture: what makes no pixels changes nothing, whatever it is") {
    Read read;
    const std::vector<glm::vec3> plain = read({});
    // XMP may name attributes of the picture, many of them, and stand one in the other.
    CHECK(read({.more = {text(700, xmp("<tiff:Orientation>3</tiff:Orientation>"))}}) == plain);
    std::string deep;
    for (int i = 0; i < 200000; ++i) deep += "<a>";
    CHECK(read({.more = {text(700, xmp(deep))}}) == plain);
    std::string many;
    for (int i = 0; i < 100000; ++i) many += "<a" + std::to_string(i) + ">1</a" + std::to_string(i) + ">";
    CHECK(read({.more = {text(700, xmp(many))}}) == plain);
    // Each field that there can be, and some of them twice.
    std::vector<Field> fields;
    for (unsigned tag = 33302; tag < 65000; ++tag)
        if (tag != 50674) fields.push_back({tag, shorts, 1, std::string(2, '\1')});
    fields.push_back({257, longs, 1, std::string(4, '\0')});
    CHECK(read({.more = fields}) == plain);
    // What says where its values are need not be right where nobody wants them.
    CHECK(read({.more = {{37500, byte, 0xFFFFFF, "none of them"}}}) == plain);
}

TEST_CASE("tiff picture: fields that claim more than the file has are refused") {
    Read read;
    const std::string whole = Tiff{}.bytes();
    CHECK(read.refusal(whole).empty());
    // The number of values of the strip's lengths, which stand in the field itself.
    const std::size_t lengths = whole.find(std::string("\x17\1\4\0\1\0\0\0", 8));
    REQUIRE(lengths != std::string::npos);
    std::string claim = whole;
    claim.replace(lengths + 4, 4, "\xFF\xFF\xFF\x3F");
    CHECK(has(read.refusal(claim), "field 279 has 1073741823 values"));
    claim = whole;
    claim.replace(lengths + 2, 1, "\x63");
    CHECK(has(read.refusal(claim), "field 279 is of an unknown type, 99"));
    CHECK(has(read.refusal(whole.substr(0, whole.size() - 20)), "cut short"));
    claim = whole;
    claim.replace(4, 4, std::string(4, '\0'));
    CHECK(has(read.refusal(claim), "cut short"));
    claim.replace(4, 4, "\xFF\xFF\xFF\xFF");
    CHECK(has(read.refusal(claim), "cut short"));
}

TEST_SUITE_END();
