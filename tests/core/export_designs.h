// Designs that have between them every part that an export writes.
#pragma once

#include <string>
#include <vector>

#include "core/design/design_file.h"
#include "tests/core/retro_designs.h"
#include "tests/core/tinted_designs.h"

namespace nacre::test {

struct ExportDesign {
    std::string name;
    Design design;
};

inline ExportDesign preset(const std::string& name) {
    return {name, load_design(NACRE_SOURCE_DIR "/presets/" + name + ".nacre")};
}

// Matt facets of an anisotropic p, which lie beneath nothing.
inline Design matt_facets() {
    Design design = design_of(GaussianLobe{0.6, 0.3});
    design.diffuse = FacetDiffuse{.albedo = {0.8, 0.5, 0.2}};
    return design;
}

// Films on steel, smooth masking and bounces that are spread evenly.
inline Design filmed() {
    Design design = design_of(BeckmannLobe{0.3, 0.3});
    design.fresnel = FilmFresnel{};
    design.shadowing.model = SmithCorrelatedMasking{};
    design.multibounce = RankOneMultibounce{};
    return design;
}

// Two tints, one layer with a picture over it, correlated masking without clamp.
inline Design shot() {
    Design design = velvet();
    design.distribution.layers[1].modulation =
        Modulation{picture_of(8, [](double x, double y) { return 0.5 + 0.4 * x * y; }), 0.8};
    design.shadowing.model = CorrelatedMasking{};
    design.shadowing.clamp = false;
    design.fresnel = ConductorFresnel{};
    design.diffuse = CoupledDiffuse{{0.3, 0.1, 0.1}};
    return design;
}

// A mirror that sends a part back where it came from.
inline Design returning() {
    Design design = lopsided(0.6);
    design.multibounce = MomentumMultibounce{};
    return design;
}

inline std::vector<ExportDesign> export_designs() {
    std::vector<ExportDesign> designs{preset("brushed-gold"), preset("satin"), preset("smiley"),
                                      preset("scarlet-car-paint")};
    designs.push_back({"matt facets", matt_facets()});
    designs.push_back({"film", filmed()});
    designs.push_back({"shot", shot()});
    designs.push_back({"retro", returning()});
    return designs;
}

}  // namespace nacre::test
