#include "core/formats/obj_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/formats/obj_lines.h"
#include "core/geometry/polygons.h"
#include "core/geometry/triangulate.h"

namespace nacre {
namespace {

// Of a number that from_chars() found out of range: whether it is too small to be told from 0.
bool vanishes(std::string_view text) {
    const std::size_t exponent = text.find_first_of("eE");
    if (exponent != std::string_view::npos) return text.substr(exponent + 1).starts_with('-');
    return text.substr(0, text.find('.')).find_first_of("123456789") == std::string_view::npos;
}

// A decimal number, whatever the locale; infinity and NaN are none.
std::optional<double> number_of(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return {};
    if (error == std::errc::result_out_of_range && vanishes(text)) return 0.0;
    if (error != std::errc() || !std::isfinite(value)) return {};
    return value;
}

// An index as written; an empty text is 0, which is not a valid index.
std::optional<long long> index_of(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    long long value = 0;
    if (text.empty()) return value;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || error == std::errc::invalid_argument) return {};
    // Out of range of any file.
    return error == std::errc() ? value : std::numeric_limits<long long>::max();
}

class Reader {
  public:
    explicit Reader(std::string name) : name_(std::move(name)) {}

    Triangles read(std::string_view text);
    std::string note() const;

  private:
    struct Polygon {
        std::size_t first_corner = 0;
        std::size_t line = 0;
    };

    [[noreturn]] void refuse(std::size_t line, const std::string& what, std::string_view found) const {
        throw UserError(name_, fmt::format("line {}", line), what, one_line(found, 60));
    }

    glm::dvec3 numbers(const std::vector<ObjWord>& words, const char* what, std::size_t needed) const;
    void read_face(const std::vector<ObjWord>& words);
    Triangles::Corner read_corner(const ObjWord& word) const;
    void skip(std::string_view keyword);
    void finish_face(std::size_t face);

    std::string name_;
    Triangles result_;
    // Their indices count from 0. A face may refer to later lines, so indices are checked when all is read.
    std::vector<Triangles::Corner> corners_;
    std::vector<Polygon> polygons_;
    std::size_t triangles_ = 0;
    std::size_t small_faces_ = 0, points_and_lines_ = 0, curves_ = 0, made_normals_ = 0, no_uvs_ = 0;
};

// The first three numbers of a statement that needs some, 0 where there are fewer. What follows is the weight
// or the colour that some programs write.
glm::dvec3 Reader::numbers(const std::vector<ObjWord>& words, const char* what, std::size_t needed) const {
    if (words.size() < needed + 1)
        refuse(words[0].line, fmt::format("{} must have {} numbers", what, needed),
               fmt::format("{}", words.size() - 1));
    glm::dvec3 result{0};
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::optional<double> value = number_of(words[i].text);
        if (!value)
            refuse(
                words[i].line,
                fmt::format("{} must be of finite numbers{}", what,
                            words[i].text.find(',') == std::string_view::npos ? "" : " with decimal points"),
                words[i].text);
        if (std::abs(*value) > coordinate_max)
            refuse(words[i].line, fmt::format("{} must be of numbers up to {:g}", what, coordinate_max),
                   words[i].text);
        if (i <= 3) result[static_cast<int>(i) - 1] = *value;
    }
    return result;
}

// v, v/vt, v//vn or v/vt/vn.
Triangles::Corner Reader::read_corner(const ObjWord& word) const {
    std::array<std::string_view, 3> parts;
    std::string_view rest = word.text;
    std::size_t count = 0;
    for (bool more = true; more && count < 3; ++count) {
        const std::size_t slash = rest.find('/');
        parts[count] = rest.substr(0, slash);
        more = slash != std::string_view::npos;
        rest = more ? rest.substr(slash + 1) : std::string_view();
    }
    std::array<int, 3> indices{};
    const std::array<std::size_t, 3> sizes{result_.positions.size(), result_.uvs.size(),
                                           result_.normals.size()};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<long long> index = index_of(parts[i]);
        if (!rest.empty() || parts[0].empty() || !index)
            refuse(word.line, "a face's corner must be v, v/vt, v//vn or v/vt/vn, each an index", word.text);
        // The last one above is -1. One that cannot be is kept as one.
        const long long from_zero = *index < 0 ? static_cast<long long>(sizes[i]) + *index : *index - 1;
        constexpr int impossible = std::numeric_limits<int>::max();
        indices[i] = parts[i].empty()                           ? absent
                     : from_zero < 0 || from_zero >= impossible ? impossible
                                                                : static_cast<int>(from_zero);
    }
    if (indices[0] == std::numeric_limits<int>::max())
        refuse(word.line, "a face names a vertex that the file does not have", word.text);
    return {indices[0], indices[2], indices[1]};
}

void Reader::read_face(const std::vector<ObjWord>& words) {
    polygons_.push_back({corners_.size(), words[0].line});
    for (std::size_t i = 1; i < words.size(); ++i) corners_.push_back(read_corner(words[i]));
    if (words.size() > 3) triangles_ += words.size() - 3;
    if (triangles_ > obj_triangles_max)
        refuse(words[0].line, "the file holds too many triangles",
               fmt::format("more than {}", obj_triangles_max));
}

void Reader::skip(std::string_view keyword) {
    constexpr std::array<std::string_view, 2> small{"p", "l"};
    constexpr std::array<std::string_view, 7> curved{"curv", "curv2", "surf", "bzp", "bsp", "cdc", "cdp"};
    const auto among = [&](const auto& names) {
        return std::find(names.begin(), names.end(), keyword) != names.end();
    };
    points_and_lines_ += among(small) ? 1 : 0;
    curves_ += among(curved) ? 1 : 0;
}

void Reader::finish_face(std::size_t face) {
    const Polygon& polygon = polygons_[face];
    const std::size_t end = face + 1 < polygons_.size() ? polygons_[face + 1].first_corner : corners_.size();
    std::vector<Triangles::Corner> corners;
    std::vector<glm::dvec3> places;
    for (std::size_t i = polygon.first_corner; i < end; ++i) {
        Triangles::Corner corner = corners_[i];
        const auto has = [](int index, std::size_t size) {
            return index == absent || static_cast<std::size_t>(index) < size;
        };
        if (!has(corner.position, result_.positions.size()))
            refuse(polygon.line, "a face names a vertex that the file does not have",
                   fmt::format("{} of {}", corner.position + 1, result_.positions.size()));
        if (!has(corner.normal, result_.normals.size())) {
            corner.normal = absent;
            ++made_normals_;
        }
        if (!has(corner.uv, result_.uvs.size())) {
            corner.uv = absent;
            ++no_uvs_;
        }
        if (!corners.empty() && corner.position == corners.back().position) continue;
        corners.push_back(corner);
    }
    while (corners.size() > 1 && corners.back().position == corners.front().position) corners.pop_back();
    if (corners.size() < 3) {
        ++small_faces_;
        return;
    }
    for (const Triangles::Corner& corner : corners)
        places.push_back(result_.positions[static_cast<std::size_t>(corner.position)]);
    for (const auto& triangle : triangulated(places))
        result_.faces.push_back({corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
}

Triangles Reader::read(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    if (const std::string_view encoding = wide_encoding(text); !encoding.empty())
        throw UserError(name_, "read", "an OBJ file must be UTF-8 or ASCII", std::string(encoding));
    ObjLines lines(text);
    std::vector<ObjWord> words;
    while (lines.next(words)) {
        const std::string_view keyword = words[0].text;
        if (keyword == "v")
            result_.positions.push_back(numbers(words, "a vertex", 3));
        else if (keyword == "vn")
            result_.normals.push_back(numbers(words, "a normal", 3));
        else if (keyword == "vt")
            result_.uvs.emplace_back(numbers(words, "a texture coordinate", 1));
        else if (keyword == "f" || keyword == "fo")
            read_face(words);
        else
            skip(keyword);
    }
    for (std::size_t i = 0; i < polygons_.size(); ++i) finish_face(i);
    return std::move(result_);
}

std::string Reader::note() const {
    std::string text;
    const auto tell = [&](std::size_t count, std::string_view what) {
        if (count > 0) text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", what, count);
    };
    tell(small_faces_, "faces of fewer than 3 corners left out");
    tell(points_and_lines_, "points and lines left out");
    tell(curves_, "curves and curved surfaces left out");
    tell(made_normals_, "normals made that the file does not have");
    tell(no_uvs_, "texture coordinates left out that the file does not have");
    return text;
}

}  // namespace

Mesh parse_obj(const std::string& text, const std::string& name, std::string* note) {
    Reader reader(name);
    Mesh mesh = mesh_of(reader.read(text));
    if (mesh.indices.empty()) throw UserError(name, "read", "the file holds no surface", reader.note());
    if (note != nullptr) *note = reader.note();
    return mesh;
}

Mesh load_obj(const std::filesystem::path& file, std::string* note) {
    return parse_obj(read_text_file(file), file.string(), note);
}

}  // namespace nacre
