#include "core/fit/fit_loss.h"

#include <algorithm>
#include <cmath>

namespace nacre {

namespace {

constexpr std::size_t chunk = 125;  // pairs of one task, whatever the threads
// |d| is smoothed to sqrt(d^2 + (part rho)^2 + least^2).
constexpr double smooth_part = 0.02, smooth_least = 1e-4;

double blur(const LobeFrame& lobe) { return 0.7 / std::sqrt(std::sqrt(lobe.determinant())); }

// Adds `scale` times the derivatives of s(k), of which Lambda is, by k's place and A.
void add_slope(const LobeFrame& lobe, const InFrame& k, double s, double scale, dvec3 direction,
               double& by_det, FrameGradient& gradient) {
    const double det = lobe.determinant(), unit = scale / (det * k.z * k.z);
    gradient.X += direction * (unit * 2 * (lobe.a22 * k.x - lobe.a12 * k.y));
    gradient.Y += direction * (unit * 2 * (lobe.a11 * k.y - lobe.a12 * k.x));
    gradient.N += direction * (scale * -2 * s / k.z);
    gradient.a22 += unit * k.x * k.x;
    gradient.a12 -= unit * 2 * k.x * k.y;
    gradient.a11 += unit * k.y * k.y;
    by_det -= scale * s / det;
}

// Adds `value` times the derivatives of log(bare).
void add_bare(const LobeFrame& lobe, const LobeTerms& terms, const FitPair& pair, double value,
              FrameGradient& gradient) {
    const InFrame& h = terms.h;
    const double unit = value * terms.kernel.log_slope / (h.z * h.z);
    gradient.X += pair.h * (unit * 2 * (lobe.a11 * h.x + lobe.a12 * h.y));
    gradient.Y += pair.h * (unit * 2 * (lobe.a22 * h.y + lobe.a12 * h.x));
    gradient.N += pair.h * (value * (terms.kernel.log_slope * -2 * terms.q - 4) / h.z);
    gradient.a11 += unit * h.x * h.x;
    gradient.a12 += unit * 2 * h.x * h.y;
    gradient.a22 += unit * h.y * h.y;
    double by_det = value * 0.5 / lobe.determinant();
    const double masked = -value / (1 + terms.lambda_v.value + terms.lambda_l.value);
    if (terms.lambda_v.slope != 0)
        add_slope(lobe, terms.v, terms.s_v, masked * terms.lambda_v.slope, pair.v, by_det, gradient);
    if (terms.lambda_l.slope != 0)
        add_slope(lobe, terms.l, terms.s_l, masked * terms.lambda_l.slope, pair.l, by_det, gradient);
    gradient.a11 += by_det * lobe.a22;
    gradient.a22 += by_det * lobe.a11;
    gradient.a12 -= by_det * 2 * lobe.a12;
}

}  // namespace

MaskValue ViewedLobe::mirrored_mask(const LobeFrame& lobe, dvec3 v) const {
    return (*mask_)(2 * glm::dot(v, lobe.N) * lobe.N - v, blur(lobe));
}

double ViewedLobe::unit_value(const LobeFrame& lobe, const FitPair& pair) const {
    LobeTerms terms;
    if (!lobe_terms(shape_, lobe, pair.v, pair.l, pair.h, terms)) return 0;
    if (weights_ == LobeWeights::constant) return terms.bare / terms.v.z;
    return terms.bare * pair.visibility * mirrored_mask(lobe, pair.v).value;
}

double ViewedLobe::view_weight(const LobeFrame& lobe, dvec3 v, double part) const {
    const double facing = glm::dot(lobe.N, v);
    return facing > 0 ? lobe.weight * facing * part * mirrored_mask(lobe, v).value : 0;
}

std::optional<double> ViewedLobe::value(const LobeFrame& lobe, const FitPair& pair,
                                        FrameGradient& gradient) const {
    LobeTerms terms;
    if (!lobe_terms(shape_, lobe, pair.v, pair.l, pair.h, terms)) return {};
    double value;
    if (weights_ == LobeWeights::constant) {
        value = lobe.weight * terms.bare / terms.v.z;
        gradient.N -= pair.v * (value / terms.v.z);
    } else {
        const MaskValue mask = mirrored_mask(lobe, pair.v);
        const double unmasked = lobe.weight * terms.bare * pair.visibility;
        value = unmasked * mask.value;
        gradient.N += unmasked * 2 * (pair.v * glm::dot(mask.by_k, lobe.N) + terms.v.z * mask.by_k);
        const double by_det = unmasked * mask.by_blur * -0.25 * blur(lobe) / lobe.determinant();
        gradient.a11 += by_det * lobe.a22;
        gradient.a22 += by_det * lobe.a11;
        gradient.a12 -= by_det * 2 * lobe.a12;
    }
    add_bare(lobe, terms, pair, value, gradient);
    gradient.log_weight += value;
    return value;
}

namespace {

struct LossPart {
    double value = 0, energy = 0;
    std::vector<FrameGradient> gradient;
};

void scale(FrameGradient& g, double by) {
    g.log_weight *= by;
    g.N *= by;
    g.X *= by;
    g.Y *= by;
    g.a11 *= by;
    g.a12 *= by;
    g.a22 *= by;
}

// What one pair adds; `seen` is room for it, and so is `own`, which is and stays 0.
void add_pair(const ViewedLobe& model, std::span<const LobeFrame> lobes, const FitPair& pair,
              std::vector<std::size_t>& seen, std::vector<FrameGradient>& own, LossPart& part) {
    seen.clear();
    double sum = 0;
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        const std::optional<double> value = model.value(lobes[i], pair, own[i]);
        if (!value) continue;
        sum += *value;
        seen.push_back(i);
    }
    const double d = sum - pair.rho, part_of_rho = smooth_part * pair.rho;
    const double size = std::sqrt(d * d + part_of_rho * part_of_rho + smooth_least * smooth_least);
    part.value += pair.share * size;
    part.energy += pair.share * pair.rho;
    for (const std::size_t i : seen) {
        scale(own[i], pair.share * d / size);
        part.gradient[i] += own[i];
        own[i] = {};
    }
}

}  // namespace

Loss fit_loss(const ViewedLobe& model, std::span<const LobeParameters> lobes, std::span<const FitPair> pairs,
              std::span<const std::size_t> indices, Workers& workers) {
    std::vector<LobeFrame> frames;
    for (const LobeParameters& lobe : lobes) frames.push_back(frame_of(lobe));
    const std::size_t tasks = (indices.size() + chunk - 1) / chunk;
    std::vector<LossPart> parts(tasks);
    workers.for_each(static_cast<int>(tasks), [&](int task) {
        LossPart& part = parts[static_cast<std::size_t>(task)];
        part.gradient.resize(lobes.size());
        std::vector<std::size_t> seen;
        std::vector<FrameGradient> own(lobes.size());
        const std::size_t begin = static_cast<std::size_t>(task) * chunk;
        for (std::size_t j = begin; j < std::min(begin + chunk, indices.size()); ++j)
            add_pair(model, frames, pairs[indices[j]], seen, own, part);
    });
    Loss loss;
    double energy = 0;
    std::vector<FrameGradient> by_frame(lobes.size());
    for (const LossPart& part : parts) {
        loss.value += part.value;
        energy += part.energy;
        for (std::size_t i = 0; i < lobes.size(); ++i) by_frame[i] += part.gradient[i];
    }
    loss.value /= energy;
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        scale(by_frame[i], 1 / energy);
        loss.gradient.push_back(by_parameters(lobes[i], by_frame[i]));
    }
    return loss;
}

namespace {

template <class BrdfOf>
double misplaced(std::span<const FitPair> pairs, const BrdfOf& brdf) {
    double wrong = 0, energy = 0;
    for (const FitPair& pair : pairs) {
        wrong += pair.share * std::fabs(brdf(pair) - pair.rho);
        energy += pair.share * pair.rho;
    }
    return wrong / energy;
}

}  // namespace

double misplaced_energy(const ViewedLobe& model, std::span<const LobeFrame> lobes,
                        std::span<const FitPair> pairs) {
    return misplaced(pairs, [&](const FitPair& pair) {
        double sum = 0;
        for (const LobeFrame& lobe : lobes) sum += lobe.weight * model.unit_value(lobe, pair);
        return sum;
    });
}

double misplaced_energy(const LobeMixture& mixture, std::span<const FitPair> pairs) {
    const MixtureReader reader(mixture);
    return misplaced(pairs, [&](const FitPair& pair) { return reader(pair.v, pair.l); });
}

}  // namespace nacre
