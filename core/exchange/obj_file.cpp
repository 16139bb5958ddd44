#include "core/exchange/obj_file.h"

#include <fmt/core.h>
#include <tiny_obj_loader.h>

#include <cmath>
#include <exception>
#include <istream>
#include <streambuf>
#include <utility>

#include "core/design/error.h"
#include "core/exchange/input_file.h"
#include "core/geometry/polygons.h"
#include "core/geometry/triangulate.h"

namespace nacre {
namespace {

// A text that is given out line by line, so that whoever reads it can be asked where it is.
class Lines : public std::streambuf {
  public:
    explicit Lines(std::string text) : text_(std::move(text)) {}
    std::size_t line() const { return line_; }

  protected:
    int_type underflow() override {
        if (next_ >= text_.size()) return traits_type::eof();
        const std::size_t end = text_.find('\n', next_);
        const std::size_t after = end == std::string::npos ? text_.size() : end + 1;
        setg(&text_[next_], &text_[next_], text_.data() + after);
        next_ = after;
        ++line_;
        return traits_type::to_int_type(*gptr());
    }

  private:
    std::string text_;
    std::size_t next_ = 0;
    std::size_t line_ = 0;
};

// Takes what tinyobjloader reads. The first thing that is wrong is kept: its calls must not throw through the
// library.
class Reader {
  public:
    Reader(const std::string& text, std::string name) : lines_(text), name_(std::move(name)) {}

    Triangles read() {
        tinyobj::callback_t calls;
        calls.vertex_cb = [](void* reader, float x, float y, float z, float) {
            static_cast<Reader*>(reader)->add("a vertex", static_cast<Reader*>(reader)->result_.positions,
                                              {x, y, z});
        };
        calls.normal_cb = [](void* reader, float x, float y, float z) {
            static_cast<Reader*>(reader)->add("a normal", static_cast<Reader*>(reader)->result_.normals,
                                              {x, y, z});
        };
        calls.texcoord_cb = [](void* reader, float x, float y, float) {
            static_cast<Reader*>(reader)->add("a texture coordinate",
                                              static_cast<Reader*>(reader)->result_.uvs, {x, y});
        };
        calls.index_cb = [](void* reader, tinyobj::index_t* corners, int count) {
            static_cast<Reader*>(reader)->add_face(corners, static_cast<std::size_t>(count));
        };
        std::istream stream(&lines_);
        std::string warnings, error;
        const bool understood = tinyobj::LoadObjWithCallback(stream, calls, this, nullptr, &warnings, &error);
        if (problem_) std::rethrow_exception(problem_);
        if (!understood) throw UserError(name_, "read", "this is no OBJ file", one_line(error, 200));
        return std::move(result_);
    }

  private:
    void refuse(const std::string& what, const std::string& found) {
        if (!problem_)
            problem_ =
                std::make_exception_ptr(UserError(name_, fmt::format("line {}", lines_.line()), what, found));
    }

    template <class Vector>
    void add(const char* what, std::vector<Vector>& field, const Vector& value) {
        if (problem_) return;
        for (int i = 0; i < Vector::length(); ++i)
            if (!std::isfinite(value[i]))
                return refuse(fmt::format("{} must be of finite numbers", what), "");
        field.push_back(value);
    }

    // From 1 on, or from -1 down for the last ones; 0 where a corner has none.
    bool resolve(const char* what, int given, std::size_t count, bool needed, int& index) {
        const auto size = static_cast<long long>(count);
        const long long from_one = given < 0 ? size + given + 1 : given;
        if (given == 0 && !needed) {
            index = absent;
            return true;
        }
        if (from_one < 1 || from_one > size) {
            refuse(fmt::format("a face names a {} that does not stand above it", what),
                   fmt::format("{} of {}", given, size));
            return false;
        }
        index = static_cast<int>(from_one - 1);
        return true;
    }

    void add_face(const tinyobj::index_t* given, std::size_t count) {
        if (problem_) return;
        if (count < 3 || count > obj_corners_max)
            return refuse(fmt::format("a face must have 3 to {} corners", obj_corners_max),
                          fmt::format("{}", count));
        if (result_.faces.size() + count - 2 > obj_triangles_max)
            return refuse("the file holds too many triangles",
                          fmt::format("more than {}", obj_triangles_max));
        std::vector<Triangles::Corner> corners(count);
        std::vector<glm::dvec3> polygon;
        for (std::size_t i = 0; i < count; ++i) {
            Triangles::Corner& corner = corners[i];
            if (!resolve("vertex", given[i].vertex_index, result_.positions.size(), true, corner.position) ||
                !resolve("normal", given[i].normal_index, result_.normals.size(), false, corner.normal) ||
                !resolve("texture coordinate", given[i].texcoord_index, result_.uvs.size(), false, corner.uv))
                return;
            polygon.emplace_back(result_.positions[static_cast<std::size_t>(corner.position)]);
        }
        for (const auto& triangle : triangulated(polygon))
            result_.faces.push_back({corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]});
    }

    Lines lines_;
    std::string name_;
    Triangles result_;
    std::exception_ptr problem_;
};

}  // namespace

Mesh parse_obj(const std::string& text, const std::string& name) {
    Mesh mesh = mesh_of(Reader(text, name).read());
    if (mesh.indices.empty()) throw UserError(name, "read", "the file holds no surface");
    fit(mesh);
    return mesh;
}

Mesh load_obj(const std::filesystem::path& file) { return parse_obj(read_text_file(file), file.string()); }

}  // namespace nacre
