#include "core/compare/opponent.h"

#include <utility>

namespace nacre {
std::vector<Opponent> all_opponents() {
    std::vector<Opponent> all;
    for (const ClosedFormInfo& model : all_closed_forms()) all.emplace_back(model.model);
    for (std::size_t i = 0; i < KindSet<MaskingModel>::count; ++i)
        all.emplace_back(KindSet<MaskingModel>::made(i));
    return all;
}

std::string name_of(const Opponent& opponent) {
    if (const auto* model = std::get_if<ClosedFormModel>(&opponent)) return info(*model).name;
    return std::string(kind_name(std::get<MaskingModel>(opponent)));
}

std::string label_of(const Opponent& opponent) {
    if (const auto* model = std::get_if<ClosedFormModel>(&opponent)) return info(*model).label;
    return std::visit([]<class T>(const T&) { return T::compared_label; }, std::get<MaskingModel>(opponent));
}

std::string citation_of(const Opponent& opponent) {
    if (const auto* model = std::get_if<ClosedFormModel>(&opponent)) return info(*model).citation;
    return std::visit([]<class T>(const T&) { return T::citation; }, std::get<MaskingModel>(opponent));
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
    if (opponent && !model) {
        const auto& masking = std::get<MaskingModel>(*opponent);
        // The design's own width stays.
        if (masking.index() != design.shadowing.model.index()) design.shadowing.model = masking;
    }
    options.albedo = options.albedo || (model && *model == ClosedFormModel::oren_nayar);
    ComparedSurface surface{baker.bake(design, options, std::move(stop), progress), nullptr};
    if (model) surface.model = std::make_shared<const ClosedForm>(matching_form(*surface.tables, *model));
    return surface;
}

}  // namespace nacre
