#include "core/fit/lobe_refine.h"

#include <algorithm>
#include <cmath>

namespace nacre {

namespace {

constexpr std::size_t weight_pairs = 20000;  // that reweigh() reads

// The normal equations of the weights.
struct Equations {
    std::vector<std::vector<double>> square;
    std::vector<double> right;
};

Equations equations(const ViewedLobe& model, std::span<const FitPair> pairs,
                    const std::vector<LobeFrame>& lobes, Workers& workers) {
    double energy = 0, space = 0;
    for (const FitPair& pair : pairs) {
        energy += pair.share * pair.rho;
        space += pair.share;
    }
    const double usual = energy / space;
    std::vector<std::vector<double>> columns(lobes.size(), std::vector<double>(pairs.size()));
    std::vector<double> target(pairs.size()), importance(pairs.size());
    for (std::size_t j = 0; j < pairs.size(); ++j) {
        importance[j] = std::sqrt(pairs[j].share / (pairs[j].rho + 0.05 * usual));
        target[j] = importance[j] * pairs[j].rho;
    }
    workers.for_each(static_cast<int>(lobes.size()), [&](int lobe) {
        const auto i = static_cast<std::size_t>(lobe);
        for (std::size_t j = 0; j < pairs.size(); ++j)
            columns[i][j] = importance[j] * model.unit_value(lobes[i], pairs[j]);
    });
    const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0;
        for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
        return sum;
    };
    Equations all{std::vector<std::vector<double>>(lobes.size()), std::vector<double>(lobes.size())};
    workers.for_each(static_cast<int>(lobes.size()), [&](int lobe) {
        const auto i = static_cast<std::size_t>(lobe);
        for (const std::vector<double>& column : columns)
            all.square[i].push_back(product(columns[i], column));
        all.right[i] = product(columns[i], target);
    });
    return all;
}

// Batches of different pairs, drawn with replacement.
void draw_batch(std::size_t pairs, Random& random, std::vector<std::size_t>& batch) {
    for (std::size_t& index : batch)
        index = std::min(static_cast<std::size_t>(uniform_random(random) * static_cast<double>(pairs)),
                         pairs - 1);
}

class Adam {
  public:
    explicit Adam(std::size_t lobes) : mean_(lobes), square_(lobes) {}

    void step(const std::vector<LobeParameters>& gradient, double rate, bool tilted,
              std::vector<LobeParameters>& lobes) {
        constexpr double keep_mean = 0.9, keep_square = 0.99, least = 1e-6;
        ++steps_;
        const double whole_mean = 1 - std::pow(keep_mean, steps_);
        const double whole_square = 1 - std::pow(keep_square, steps_);
        for (std::size_t i = 0; i < lobes.size(); ++i) {
            for (std::size_t j = 0; j < lobes[i].size(); ++j) {
                if (!tilted && (j == 1 || j == 2)) continue;
                const double g = std::isfinite(gradient[i][j]) ? gradient[i][j] : 0;
                mean_[i][j] = keep_mean * mean_[i][j] + (1 - keep_mean) * g;
                square_[i][j] = keep_square * square_[i][j] + (1 - keep_square) * g * g;
                lobes[i][j] -=
                    rate * mean_[i][j] / whole_mean / (std::sqrt(square_[i][j] / whole_square) + least);
            }
            keep_within(lobes[i]);
        }
    }

  private:
    int steps_ = 0;
    std::vector<LobeParameters> mean_, square_;
};

}  // namespace

// One weight after the other, until none moves.
void reweigh(const ViewedLobe& model, std::span<const FitPair> pairs, std::vector<LobeFrame>& lobes,
             Workers& workers) {
    constexpr int rounds = 2000;
    const Equations all = equations(model, pairs.first(std::min(pairs.size(), weight_pairs)), lobes, workers);
    std::vector<double> weights(lobes.size(), 0.0);
    for (int round = 0; round < rounds; ++round) {
        double moved = 0, largest = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            if (all.square[i][i] <= 0) continue;
            double rest = all.right[i];
            for (std::size_t j = 0; j < weights.size(); ++j) rest -= all.square[i][j] * weights[j];
            const double better = std::clamp(weights[i] + rest / all.square[i][i], 0.0, weight_max);
            moved = std::max(moved, std::fabs(better - weights[i]));
            largest = std::max(largest, better);
            weights[i] = better;
        }
        if (moved <= 1e-8 * largest) break;
    }
    for (std::size_t i = 0; i < weights.size(); ++i) lobes[i].weight = std::max(weights[i], 1e-7);
}

std::vector<LobeFrame> refine(const ViewedLobe& model, std::span<const FitPair> pairs,
                              const std::vector<LobeFrame>& start, const RefineSettings& settings,
                              Workers& workers, const std::function<void(double)>& progress) {
    constexpr double full_rate = 0.04;
    std::vector<LobeParameters> lobes;
    for (const LobeFrame& lobe : start) lobes.push_back(parameters_of(lobe));
    Random random(settings.seed);
    Adam adam(lobes.size());
    std::vector<std::size_t> batch(static_cast<std::size_t>(settings.batch));
    for (int step = 0; step < settings.steps; ++step) {
        draw_batch(pairs.size(), random, batch);
        const Loss loss = fit_loss(model, lobes, pairs, batch, workers);
        // Full speed for half of the way, then ever slower.
        const double done = static_cast<double>(step) / settings.steps;
        const double rate = full_rate * std::min(1.0, 2 * (1 - done) + 0.02) * (done < 0.9 ? 1 : 0.3);
        adam.step(loss.gradient, rate, settings.tilted, lobes);
        progress(static_cast<double>(step + 1) / settings.steps);
    }
    std::vector<LobeFrame> refined;
    for (const LobeParameters& lobe : lobes) refined.push_back(frame_of(lobe));
    return refined;
}

}  // namespace nacre
