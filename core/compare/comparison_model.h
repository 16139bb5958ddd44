// What a design can be compared with: a model with a closed form, or its own p with another masking.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/bake/baker.h"
#include "core/compare/closed_form.h"

namespace nacre {

using ComparisonModel = std::variant<ClosedFormModel, MaskingModel>;

std::vector<ComparisonModel> all_comparison_models();
std::string name_of(const ComparisonModel& comparison_model);      // on the command line
std::string label_of(const ComparisonModel& comparison_model);     // on the screen
std::string citation_of(const ComparisonModel& comparison_model);  // author, year, equation
std::optional<ComparisonModel> comparison_model_by_name(std::string_view name);

// What a renderer draws: a baked design, or a model in its place.
struct ComparedSurface {
    std::shared_ptr<const Tables> tables;
    std::shared_ptr<const ClosedForm> model;  // null: the design itself
};

// The comparison model of the design, or without one the design. Errors and cancelling as Baker::bake().
ComparedSurface bake_for_comparison(Baker& baker, Design design,
                                    const std::optional<ComparisonModel>& comparison_model,
                                    BakeOptions options = {}, std::stop_token stop = {},
                                    const std::function<void(double)>& progress = {});

}  // namespace nacre
