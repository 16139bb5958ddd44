#include "core/geometry/polygons.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>

namespace nacre {
namespace {

using Corner = Triangles::Corner;

// A face with an area, in double: a file's coordinates may be as large as float has them.
struct Face {
    std::array<Corner, 3> corners;
    glm::dvec3 normal{0};           // unit
    std::array<double, 3> angle{};  // at each corner
    glm::dvec3 along_u{0};          // unit; 0 where u does not vary
    bool mirrored = false;          // v runs the other way round
};

// False where the face has no area.
bool measure(Face& face, const Triangles& triangles) {
    std::array<glm::dvec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = triangles.positions[static_cast<std::size_t>(face.corners[i].position)];
    const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double area = glm::length(cross);
    if (!(area > 0)) return false;
    face.normal = cross / area;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
        face.angle[i] = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }
    if (std::any_of(face.corners.begin(), face.corners.end(), [](const Corner& c) { return c.uv == absent; }))
        return true;
    std::array<glm::dvec2, 3> t;
    for (std::size_t i = 0; i < 3; ++i) t[i] = triangles.uvs[static_cast<std::size_t>(face.corners[i].uv)];
    const glm::dvec2 d = t[1] - t[0], e = t[2] - t[0];
    const double turn = d.x * e.y - e.x * d.y;
    const glm::dvec3 u =
        (p[1] - p[0]) * e.y - (p[2] - p[0]) * d.y;  // times turn: dP/du      (Lengyel 2001, eq. 7)
    if (turn == 0 || !(glm::length(u) > 0)) return true;
    face.along_u = glm::normalize(u) * (turn > 0 ? 1.0 : -1.0);
    face.mirrored = turn < 0;
    return true;
}

std::vector<Face> measured_faces(const Triangles& triangles) {
    std::vector<Face> faces;
    faces.reserve(triangles.faces.size());
    for (const auto& corners : triangles.faces) {
        Face face;
        face.corners = corners;
        if (measure(face, triangles)) faces.push_back(face);
    }
    return faces;
}

// Which corners (3 face + i) meet at each position, one position after the other.
class Meeting {
  public:
    Meeting(const std::vector<Face>& faces, std::size_t positions) : begin_(positions + 1) {
        for (const Face& face : faces)
            for (const Corner& c : face.corners) ++begin_[static_cast<std::size_t>(c.position) + 1];
        for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        corners_.resize(faces.size() * 3);
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t f = 0; f < faces.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i)
                corners_[next[static_cast<std::size_t>(faces[f].corners[i].position)]++] = 3 * f + i;
    }

    // Calls see(face, its corner) for each at the position.
    template <class See>
    void at(int position, const See& see) const {
        const auto p = static_cast<std::size_t>(position);
        for (std::size_t i = begin_[p]; i < begin_[p + 1]; ++i) see(corners_[i] / 3, corners_[i] % 3);
    }

  private:
    std::vector<std::size_t> begin_, corners_;
};

glm::dvec3 normal_at(const Triangles& triangles, const std::vector<Face>& faces, const Meeting& meeting,
                     const Face& face, std::size_t corner, double least_cosine) {
    const Corner& c = face.corners[corner];
    if (c.normal != absent) {
        const glm::dvec3 given(triangles.normals[static_cast<std::size_t>(c.normal)]);
        const double length = glm::length(given);
        if (length > 0 && std::isfinite(length)) return given / length;
    }
    glm::dvec3 sum{0};
    meeting.at(c.position, [&](std::size_t f, std::size_t i) {
        if (glm::dot(faces[f].normal, face.normal) >= least_cosine)
            sum += faces[f].normal * faces[f].angle[i];
    });
    const double length = glm::length(sum);
    return length > 0 ? sum / length : face.normal;
}

// What two corners have in common that become one vertex.
using Key = std::tuple<int, float, float, float, int, bool>;  // position, normal, uv, mirrored

class Assembly {
  public:
    // Returns the vertex. Tangents are summed until finish().
    std::uint32_t add(const Triangles& triangles, const Face& face, std::size_t corner,
                      glm::dvec3 exact_normal) {
        const Corner& c = face.corners[corner];
        const glm::vec3 normal(exact_normal);
        const auto [entry, fresh] =
            vertices_.try_emplace(Key{c.position, normal.x, normal.y, normal.z, c.uv, face.mirrored},
                                  static_cast<std::uint32_t>(mesh_.positions.size()));
        const std::uint32_t vertex = entry->second;
        if (fresh) {
            mesh_.positions.push_back(triangles.positions[static_cast<std::size_t>(c.position)]);
            mesh_.normals.push_back(normal);
            sums_.emplace_back(0);
        }
        const glm::dvec3 across = face.along_u - exact_normal * glm::dot(exact_normal, face.along_u);
        const double length = glm::length(across);
        if (length > 1e-6) sums_[vertex] += across * (face.angle[corner] / length);
        return vertex;
    }

    // Whose order follows the side that the vertices' normals point to.
    void add_triangle(const Face& face, std::array<std::uint32_t, 3> vertices) {
        glm::dvec3 mean{0};
        for (const std::uint32_t vertex : vertices) mean += glm::dvec3(mesh_.normals[vertex]);
        if (glm::dot(mean, face.normal) < 0) std::swap(vertices[1], vertices[2]);
        mesh_.indices.insert(mesh_.indices.end(), vertices.begin(), vertices.end());
    }

    Mesh finish() && {
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            const glm::dvec3 normal(mesh_.normals[i]);
            const glm::dvec3 across = sums_[i] - normal * glm::dot(normal, sums_[i]);
            const double length = glm::length(across);
            mesh_.tangents.emplace_back(length > 1e-6 ? across / length : glm::dvec3(0));
        }
        return std::move(mesh_);
    }

  private:
    std::map<Key, std::uint32_t> vertices_;
    Mesh mesh_;
    std::vector<glm::dvec3> sums_;
};

}  // namespace

Mesh mesh_of(const Triangles& triangles, double crease) {
    const std::vector<Face> faces = measured_faces(triangles);
    const Meeting meeting(faces, triangles.positions.size());
    const double least_cosine = std::cos(crease * std::numbers::pi / 180);
    Assembly assembly;
    for (const Face& face : faces) {
        std::array<std::uint32_t, 3> vertices{};
        for (std::size_t i = 0; i < 3; ++i)
            vertices[i] =
                assembly.add(triangles, face, i, normal_at(triangles, faces, meeting, face, i, least_cosine));
        assembly.add_triangle(face, vertices);
    }
    return std::move(assembly).finish();
}

}  // namespace nacre
