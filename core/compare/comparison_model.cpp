#include "core/compare/comparison_model.h"

#include <utility>

namespace nacre {
std::vector<ComparisonModel> all_comparison_models() {
    std::vector<ComparisonModel> all;
    for (const ClosedFormInfo& model : all_closed_forms()) all.emplace_back(model.model);
    for (std::size_t i = 0; i < KindSet<MaskingModel>::count; ++i)
        all.emplace_back(KindSet<MaskingModel>::made(i));
    return all;
}

std::string name_of(const ComparisonModel& comparison_model) {
    if (const auto* model = std::get_if<ClosedFormModel>(&comparison_model)) return info(*model).name;
    return std::string(kind_name(std::get<MaskingModel>(comparison_model)));
}

std::string label_of(const ComparisonModel& comparison_model) {
    if (const auto* model = std::get_if<ClosedFormModel>(&comparison_model)) return info(*model).label;
    return std::visit([]<class T>(const T&) { return T::compared_label; },
                      std::get<MaskingModel>(comparison_model));
}

std::string citation_of(const ComparisonModel& comparison_model) {
    if (const auto* model = std::get_if<ClosedFormModel>(&comparison_model)) return info(*model).citation;
    return std::visit([]<class T>(const T&) { return T::citation; },
                      std::get<MaskingModel>(comparison_model));
}

std::optional<ComparisonModel> comparison_model_by_name(std::string_view name) {
    for (const ComparisonModel& comparison_model : all_comparison_models())
        if (name_of(comparison_model) == name) return comparison_model;
    return {};
}

ComparedSurface bake_for_comparison(Baker& baker, Design design,
                                    const std::optional<ComparisonModel>& comparison_model,
                                    BakeOptions options, std::stop_token stop,
                                    const std::function<void(double)>& progress) {
    const auto* const model = comparison_model ? std::get_if<ClosedFormModel>(&*comparison_model) : nullptr;
    if (comparison_model && !model) {
        const auto& masking = std::get<MaskingModel>(*comparison_model);
        // The design's own width stays.
        if (masking.index() != design.shadowing.model.index()) design.shadowing.model = masking;
    }
    options.albedo = options.albedo || (model && *model == ClosedFormModel::oren_nayar);
    ComparedSurface surface{baker.bake(design, options, std::move(stop), progress), nullptr};
    if (model) surface.model = std::make_shared<const ClosedForm>(matching_form(*surface.tables, *model));
    return surface;
}

}  // namespace nacre
