#pragma once

#include <optional>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/limits.h"
#include "core/model/fresnel/conductor.h"
#include "core/model/fresnel/dielectric.h"
#include "core/model/fresnel/measured.h"
#include "core/model/fresnel/shader_fresnel.h"
#include "core/model/kinds/kind.h"
#include "core/model/kinds/parameter.h"

namespace nacre {

// One film of a stack.
struct FilmLayer {
    double ior = 1.5;
    double thickness = 300;  // nm
    bool operator==(const FilmLayer&) const = default;

    static constexpr const char* name = "film";
    static constexpr const char* label = "Film";
    static constexpr const char* explanation = "One film of a stack.";
    static constexpr auto parameters() {
        return std::tuple{
            NumberParameter<FilmLayer>{.member = &FilmLayer::ior,
                                       .text = {"ior", "Film IOR",
                                                "Index of refraction of the film: water 1.33, oil and "
                                                "lacquer 1.5, zirconia 2.1, titania 2.4."},
                                       .bounds = {limits::ior_min, limits::film_ior_max},
                                       .slider = {.ends = {1, 2.6}}},
            NumberParameter<FilmLayer>{.member = &FilmLayer::thickness,
                                       .text = {"thickness", "Thickness",
                                                "Thickness of the film in nanometres. Colours are strongest "
                                                "from 100 to 800 nm and fade to grey "
                                                "beyond 2000."},
                                       .bounds = {0, limits::film_thickness_max},
                                       .slider = {.ends = {0, 1000}, .format = "%.0f nm"}}};
    }
};

// Thin films on another surface: interference of what each border reflects, at every wavelength, integrated
// to a colour.
struct FilmFresnel {
    // What the films may lie on: models with an index, since a film needs its phase.
    using Base = std::variant<DielectricFresnel, ConductorFresnel, MeasuredFresnel>;

    Base over = MeasuredFresnel{Material::steel};
    std::vector<FilmLayer> stack = {FilmLayer{}};
    bool operator==(const FilmFresnel&) const = default;

    static constexpr const char* name = "film";
    static constexpr const char* label = "Thin film";
    static constexpr const char* explanation =
        "Thin films on glass or metal, as oil on water, temper colours of steel or a coated lens: colours of "
        "interference, made under D65.";
    static constexpr const char* note = "";
    static constexpr int file_version = 2;
    static constexpr auto parameters() {
        return std::tuple{
            KindParameter<FilmFresnel, Base>{.member = &FilmFresnel::over,
                                             .text = {"over", "Film over", "What the films lie on."},
                                             .no_other = "a film needs the index of what it lies on; the "
                                                         "window's Fresnel list converts any model to "
                                                         "one of these"},
            ListParameter<FilmFresnel, FilmLayer>{
                .member = &FilmFresnel::stack,
                .text = {"stack", "Films", "The films, the outermost first."},
                .rows_max = limits::film_layers_max}};
    }

    // That the wavelengths and the nodes of the table resolve.
    std::optional<KindFault> fault() const;

    static constexpr const char* formula = curve_formula;
    static constexpr FresnelTables tables = FresnelTables::exact;
    static constexpr bool is_curve = true;
    ShaderFresnel shader(double above = 1) const;
    static std::vector<std::pair<const char*, FilmFresnel>> singular();

    // As integrated, not clipped.
    Reflectance reflectance(double above = 1) const;
    // One film, on a dielectric for a dark colour and on the nearest measured material otherwise.
    static FilmFresnel of_reflectance(const Reflectance& wanted);
};

}  // namespace nacre
