#include "core/geometry/polygons.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "core/geometry/normal_sums.h"

namespace nacre {
namespace {

using Corner = Triangles::Corner;

// A face with an area.
struct Face {
    std::array<Corner, 3> corners;
    glm::dvec3 normal{0};           // unit
    std::array<double, 3> angle{};  // at each corner
    glm::dvec3 along_u{0};          // unit; 0 where u does not vary
    bool mirrored = false;          // v runs the other way round
};

// Twice the area of a face whose edges have a size about 1: what is no more than the corners' rounding.
constexpr double no_area = 1e-14;

// Both by one power of 2, so that the larger has a size about 1. False where both are 0.
template <class Vector>
bool bring_to_usual_size(Vector& a, Vector& b) {
    double largest = 0;
    for (int i = 0; i < Vector::length(); ++i) largest = std::max({largest, std::abs(a[i]), std::abs(b[i])});
    if (!(largest > 0)) return false;
    const int exponent = -std::ilogb(largest);
    for (int i = 0; i < Vector::length(); ++i) {
        a[i] = std::scalbn(a[i], exponent);
        b[i] = std::scalbn(b[i], exponent);
    }
    return true;
}

// Which way u runs on the face whose edges from its first corner are p and q.
void measure_u(Face& face, const Triangles& triangles, glm::dvec3 p, glm::dvec3 q) {
    std::array<glm::dvec2, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
        if (face.corners[i].uv == absent) return;
        t[i] = triangles.uvs[static_cast<std::size_t>(face.corners[i].uv)];
    }
    glm::dvec2 d = t[1] - t[0], e = t[2] - t[0];
    if (!bring_to_usual_size(d, e)) return;
    const double turn = d.x * e.y - e.x * d.y;
    const glm::dvec3 u = p * e.y - q * d.y;  // times turn: dP/du      (Lengyel 2001, eq. 7)
    if (turn == 0 || !(glm::length(u) > 0)) return;
    face.along_u = glm::normalize(u) * (turn > 0 ? 1.0 : -1.0);
    face.mirrored = turn < 0;
}

// False where the face has no area.
bool measure(Face& face, const Triangles& triangles) {
    const auto position = [&](std::size_t i) {
        return triangles.positions[static_cast<std::size_t>(face.corners[i].position)];
    };
    glm::dvec3 p = position(1) - position(0), q = position(2) - position(0);
    if (!bring_to_usual_size(p, q)) return false;
    const glm::dvec3 cross = glm::cross(p, q);
    const double area = glm::length(cross);
    if (!(area > no_area)) return false;
    face.normal = cross / area;
    const auto angle = [&](glm::dvec3 a, glm::dvec3 b) { return std::atan2(area, glm::dot(a, b)); };
    face.angle = {angle(p, q), angle(-p, q - p), angle(-q, p - q)};
    measure_u(face, triangles, p, q);
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

    std::size_t count(int position) const {
        const auto p = static_cast<std::size_t>(position);
        return begin_[p + 1] - begin_[p];
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

// Normals at corners: the given one, or what the faces around have.
class CornerNormals {
  public:
    CornerNormals(const Triangles& triangles, const std::vector<Face>& faces, double crease)
        : triangles_(triangles),
          faces_(faces),
          meeting_(faces, triangles.positions.size()),
          crease_(crease) {}

    glm::dvec3 at(const Face& face, std::size_t corner) {
        const Corner& c = face.corners[corner];
        if (c.normal != absent) {
            glm::dvec3 given = triangles_.normals[static_cast<std::size_t>(c.normal)], none{0};
            if (bring_to_usual_size(given, none)) return glm::normalize(given);
        }
        const glm::dvec3 sum = around(c.position, face.normal);
        const double length = glm::length(sum);
        return length > 0 ? sum / length : face.normal;
    }

  private:
    static constexpr std::size_t few = 64;  // faces around a position that are gone through one by one

    glm::dvec3 around(int position, glm::dvec3 normal) {
        if (meeting_.count(position) > few) return many_around(position).within(normal, crease_);
        const double least_cosine = std::cos(crease_);
        glm::dvec3 sum{0};
        meeting_.at(position, [&](std::size_t f, std::size_t i) {
            if (glm::dot(faces_[f].normal, normal) >= least_cosine)
                sum += faces_[f].normal * faces_[f].angle[i];
        });
        return sum;
    }

    const NormalSums& many_around(int position) {
        const auto found = many_.find(position);
        if (found != many_.end()) return found->second;
        std::vector<WeightedNormal> normals;
        meeting_.at(position, [&](std::size_t f, std::size_t i) {
            normals.push_back({faces_[f].normal, faces_[f].angle[i]});
        });
        return many_.emplace(position, NormalSums(std::move(normals))).first->second;
    }

    const Triangles& triangles_;
    const std::vector<Face>& faces_;
    Meeting meeting_;
    double crease_;  // radians
    std::map<int, NormalSums> many_;
};

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
                                  static_cast<std::uint32_t>(positions_.size()));
        const std::uint32_t vertex = entry->second;
        if (fresh) {
            positions_.push_back(triangles.positions[static_cast<std::size_t>(c.position)]);
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
        if (!positions_.empty()) fit(positions_);
        mesh_.positions.assign(positions_.begin(), positions_.end());
        return std::move(mesh_);
    }

  private:
    std::map<Key, std::uint32_t> vertices_;
    Mesh mesh_;
    std::vector<glm::dvec3> positions_, sums_;
};

}  // namespace

Mesh mesh_of(const Triangles& triangles, double crease) {
    const std::vector<Face> faces = measured_faces(triangles);
    CornerNormals normals(triangles, faces, crease * std::numbers::pi / 180);
    Assembly assembly;
    for (const Face& face : faces) {
        std::array<std::uint32_t, 3> vertices{};
        for (std::size_t i = 0; i < 3; ++i)
            vertices[i] = assembly.add(triangles, face, i, normals.at(face, i));
        assembly.add_triangle(face, vertices);
    }
    return std::move(assembly).finish();
}

}  // namespace nacre
