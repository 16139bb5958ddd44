#include "core/measure/opponent.h"

#include <utility>

#include "core/design/design_names.h"

namespace nacre {
namespace {

struct MaskingInfo {
    const char* label;
    const char* citation;
};

// In the order of ShadowingModel.
constexpr MaskingInfo maskings[] = {
    {"Same p, uncorrelated", "Ashikhmin, Premoze and Shirley 2000, eq. 26"},
    {"Same p, by azimuth", "Ashikhmin, Premoze and Shirley 2000, eq. 14"},
    {"Same p, Smith by height", "Heitz 2014, eq. 99"},
};

const MaskingInfo& info(ShadowingModel model) { return maskings[static_cast<std::size_t>(model)]; }

}  // namespace

std::vector<Opponent> all_opponents() {
    std::vector<Opponent> all;
    for (const ClosedFormInfo& model : all_closed_forms()) all.emplace_back(model.model);
    for (std::size_t i = 0; i < shadowing_names.size(); ++i) all.emplace_back(static_cast<ShadowingModel>(i));
    return all;
}

std::string name_of(const Opponent& opponent) {
    if (const auto* model = std::get_if<ClosedFormModel>(&opponent)) return info(*model).name;
    return std::string(shadowing_names[static_cast<std::size_t>(std::get<ShadowingModel>(opponent))]);
}

std::string label_of(const Opponent& opponent) {
    return std::visit([](auto model) { return std::string(info(model).label); }, opponent);
}

std::string citation_of(const Opponent& opponent) {
    return std::visit([](auto model) { return std::string(info(model).citation); }, opponent);
}

std::optional<Opponent> opponent_by_name(std::string_view name) {
    for (const Opponent& opponent : all_opponents())
        if (name_of(opponent) == name) return opponent;
    return {};
}

ComparedSurface bake_compared(Baker& baker, Design design, const std::optional<Opponent>& opponent,
                              BakeOptions options, std::stop_token stop,
                              const std::function<void(double)>& progress) {
    const auto* const model = opponent ? std::get_if<ClosedFormModel>(&*opponent) : nullptr;
    if (opponent && !model) design.shadowing.model = std::get<ShadowingModel>(*opponent);
    options.albedo = options.albedo || (model && *model == ClosedFormModel::oren_nayar);
    ComparedSurface surface{baker.bake(design, options, std::move(stop), progress), nullptr};
    if (model) surface.model = std::make_shared<const ClosedForm>(matching_form(*surface.tables, *model));
    return surface;
}

}  // namespace nacre
