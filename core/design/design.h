// The document: everything an artist edits, as one plain value. Panels edit it, the bake reads it,
// undo keeps it and the file holds it. Angles in degrees, colours linear Rec. 709.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace nacre {

// A grey picture of the hemisphere seen from above: an equal-area (Lambert azimuthal) disk that
// touches the four sides, +x right, +y up. Row-major, top row first, finite values >= 0.
struct Raster {
    int width = 0;  // pixels; equal to height, at least 1
    int height = 0;
    std::vector<float> values;

    bool operator==(const Raster&) const = default;
};

// What is worth to be said of a picture that was read: a part that is not used, a size that was changed.
// One sentence each, without the file.
using PictureNotes = std::vector<std::string>;

// A raster held in the design, or a picture file that stands beside it. `file` is absolute and empty
// when the raster is held in the design. `raster` is never null in a loaded design.
struct Picture {
    std::filesystem::path file;
    std::shared_ptr<const Raster> raster;
    PictureNotes notes = {};  // of the file that was read; no part of the design

    bool operator==(const Picture& other) const;
};

// Ashikhmin et al. 2000, eq. 34. Slopes; infinity makes a cylinder along the other axis.
struct GaussianLobe {
    double sigma_x = 0.2;
    double sigma_y = 0.2;
    bool operator==(const GaussianLobe&) const = default;
};

// Ashikhmin et al. 2000, eq. 35.
struct InverseGaussianLobe {
    double sigma = 0.5;
    bool operator==(const InverseGaussianLobe&) const = default;
};

// Walter et al. 2007, anisotropic as in Heitz 2014.
struct GgxLobe {
    double alpha_x = 0.2;
    double alpha_y = 0.2;
    bool operator==(const GgxLobe&) const = default;
};

struct BeckmannLobe {
    double alpha_x = 0.2;
    double alpha_y = 0.2;
    bool operator==(const BeckmannLobe&) const = default;
};

enum class UniformDomain { hemisphere, sphere };

struct UniformLobe {
    UniformDomain domain = UniformDomain::hemisphere;
    bool operator==(const UniformLobe&) const = default;
};

// p(theta) through (theta in degrees, value) points with straight lines between them; 0 outside.
struct CurveLobe {
    std::vector<std::pair<double, double>> points = {{0, 1}, {20, 0}};
    bool operator==(const CurveLobe&) const = default;
};

struct PaintedLobe {
    Picture image;
    bool operator==(const PaintedLobe&) const = default;
};

using Lobe = std::variant<GaussianLobe, InverseGaussianLobe, GgxLobe, BeckmannLobe, UniformLobe, CurveLobe,
                          PaintedLobe>;

// Multiplies a lobe by 1 - strength + strength * picture, the picture lying in the lobe's own frame
// and being black outside its disk.
struct Modulation {
    Picture image;
    double strength = 1;
    bool operator==(const Modulation&) const = default;
};

struct Layer {
    std::string name;
    bool enabled = true;
    Lobe lobe = GaussianLobe{};
    double weight = 1;    // share of facet area, relative to the other layers'
    double rotation = 0;  // about the lobe's own axis, first
    double tilt = 0;      // then the axis leans from n ...
    double azimuth = 0;   // ... toward this azimuth
    std::optional<Modulation> modulation;

    bool operator==(const Layer&) const = default;
};

struct Distribution {
    std::vector<Layer> layers = {Layer{}};
    double mean_cosine_scale = 1;  // multiplies N = <n.h>; the paper doubles it for slanted velvet
    bool operator==(const Distribution&) const = default;
};

enum class ShadowingModel { uncorrelated, correlated, smith_correlated };

struct Shadowing {
    ShadowingModel model = ShadowingModel::uncorrelated;
    double width = 15;  // degrees; `correlated` only
    bool clamp = true;  // P~ = min(1, N c / g); false is the paper's own form
    bool operator==(const Shadowing&) const = default;
};

struct SchlickFresnel {
    glm::dvec3 f0{0.05};
    bool operator==(const SchlickFresnel&) const = default;
};

struct DielectricFresnel {
    double ior = 1.5;
    bool operator==(const DielectricFresnel&) const = default;
};

struct ConductorFresnel {
    glm::dvec3 eta{0.2, 0.92, 1.1};
    glm::dvec3 k{3.9, 2.45, 2.14};
    bool operator==(const ConductorFresnel&) const = default;
};

struct NoFresnel {
    bool operator==(const NoFresnel&) const = default;
};

using Fresnel = std::variant<SchlickFresnel, DielectricFresnel, ConductorFresnel, NoFresnel>;

struct NoDiffuse {
    bool operator==(const NoDiffuse&) const = default;
};

// Eq. 27; kd + ks <= 1.
struct LambertianDiffuse {
    double kd = 0.5;
    double ks = 0.5;
    glm::dvec3 albedo{0.5};
    bool operator==(const LambertianDiffuse&) const = default;
};

// Eq. 28 to 30.
struct CoupledDiffuse {
    glm::dvec3 albedo{0.5};
    bool operator==(const CoupledDiffuse&) const = default;
};

// The paper's metal: ones of eq. 30 become f0, the albedo is f0.
struct MetalDiffuse {
    bool operator==(const MetalDiffuse&) const = default;
};

using Diffuse = std::variant<NoDiffuse, LambertianDiffuse, CoupledDiffuse, MetalDiffuse>;

struct Design {
    std::string name;
    std::string note;
    Distribution distribution;
    Shadowing shadowing;
    Fresnel fresnel = SchlickFresnel{};
    Diffuse diffuse = NoDiffuse{};

    bool operator==(const Design&) const = default;
};

// Bounds that the file, the panels and the bake agree on.
namespace limits {
inline constexpr double width_min = 1e-5;  // sigma and alpha, slopes
inline constexpr double width_max = 1e5;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double weight_max = 1e30;
inline constexpr double mean_cosine_scale_min = 1e-3;
inline constexpr double mean_cosine_scale_max = 100;
inline constexpr double tilt_max = 180;         // degrees
inline constexpr double angle_max = 360;        // degrees, either sign: azimuth, rotation
inline constexpr double correlation_min = 0.1;  // degrees
inline constexpr double correlation_max = 180;
inline constexpr double ior_min = 1;
inline constexpr double ior_max = 10;
inline constexpr double eta_min = 1e-3;
inline constexpr double eta_max = 100;
inline constexpr double k_max = 100;
inline constexpr int layers_max = 16;
inline constexpr int curve_points_max = 256;
inline constexpr int raster_max = 1024;   // pixels a side, as the bake uses it
inline constexpr int picture_max = 4096;  // pixels a side, as a file may have; averaged down
inline constexpr std::uintmax_t file_bytes_max = 256u << 20;  // of a design or a picture
}  // namespace limits

}  // namespace nacre
