// The parameters of a model that shares the light out between the highlight and a diffuse part, kd + ks <= 1.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "core/model/diffuse/albedo_text.h"
#include "core/model/kinds/kind.h"

namespace nacre {

template <class T>
constexpr auto share_parameters() {
    constexpr Range share{0, 1};
    return std::tuple{
        NumberParameter<T>{
            .member = &T::kd,
            .text = {"kd", "Diffuse kd", "Share of the diffuse part: kd times it. kd + ks stays at most 1."},
            .bounds = share,
            .slider = {.ends = share}},
        NumberParameter<T>{
            .member = &T::ks,
            .text = {"ks", "Specular ks",
                     "Share of the highlight: ks times the specular term. kd + ks stays at most 1."},
            .bounds = share,
            .slider = {.ends = share}},
        ColourParameter<T>{.member = &T::albedo, .text = diffuse_albedo_text, .bounds = share}};
}

template <class T>
std::optional<KindFault> share_fault(const T& model) {
    constexpr double rounding = 1e-9;
    if (model.kd + model.ks <= 1 + rounding) return {};
    return KindFault{"", "kd + ks must not exceed 1, or energy is created",
                     fmt::format("{} + {} = {}", model.kd, model.ks, model.kd + model.ks)};
}

// After one share was changed by hand: the other one makes room.
template <class T>
void make_other_share_fit(T& model, double T::*changed) {
    if (changed == &T::kd) model.ks = std::min(model.ks, 1 - model.kd);
    if (changed == &T::ks) model.kd = std::min(model.kd, 1 - model.ks);
}

}  // namespace nacre
