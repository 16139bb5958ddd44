#include "core/plot/curve_sampler.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

constexpr int first_intervals = 48;
constexpr int halvings_max = 7;
constexpr double tolerance = 0.005;
constexpr double log_tolerance = 0.05;   // of the value itself
constexpr double log_floor = 1e-4;       // of the largest value: what lies below is not seen
constexpr double hint_narrowest = 1e-3;  // distance of the nearest samples beside a hint, ...
constexpr double hint_widest = 8;        // ... and of the farthest
constexpr double hint_factor = 2;

// One abscissa with the values of all curves.
struct Sample {
    double x;
    std::vector<double> values;
};

std::vector<double> first_abscissae(const CurveRange& range) {
    std::vector<double> at;
    for (int i = 0; i <= first_intervals; ++i)
        at.push_back(std::lerp(range.low, range.high, i / double(first_intervals)));
    const auto add = [&](double x) {
        if (x > range.low && x < range.high) at.push_back(x);
    };
    for (const double hint : range.hints) {
        add(hint);
        for (double off = hint_narrowest; off < hint_widest; off *= hint_factor)
            add(hint - off), add(hint + off);
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end(), [](double a, double b) { return b - a < 1e-9; }), at.end());
    return at;
}

class Sampler {
  public:
    Sampler(const CurveRange& range, std::size_t curves, const CurvesAt& values_at)
        : range_(range), curves_(curves), values_at_(values_at) {
        for (const double x : first_abscissae(range)) samples_.push_back(sample(x));
        largest_.assign(curves, 0);
        for (const Sample& s : samples_)
            for (std::size_t c = 0; c < curves; ++c)
                largest_[c] = std::max(largest_[c], std::fabs(s.values[c]));
    }

    SampledCurves refined() {
        std::vector<bool> bends(samples_.size() - 1, true);  // of the interval that begins with a sample
        for (int round = 0; round < halvings_max; ++round) bends = halve(bends);
        SampledCurves result;
        result.values.resize(curves_);
        for (const Sample& s : samples_) {
            result.at.push_back(s.x);
            for (std::size_t c = 0; c < curves_; ++c) result.values[c].push_back(s.values[c]);
        }
        return result;
    }

  private:
    Sample sample(double x) const {
        Sample made{x, std::vector<double>(curves_)};
        values_at_(x, made.values);
        return made;
    }

    bool far_from_chord(const Sample& a, const Sample& middle, const Sample& b) const {
        for (std::size_t c = 0; c < curves_; ++c) {
            const double off = std::fabs(middle.values[c] - 0.5 * (a.values[c] + b.values[c]));
            if (off > tolerance * largest_[c]) return true;
            if (range_.logarithmic &&
                off > log_tolerance * std::max(std::fabs(middle.values[c]), log_floor * largest_[c]))
                return true;
        }
        return false;
    }

    // Halves the intervals that bend; both halves of one that is found far from its chord bend again.
    std::vector<bool> halve(const std::vector<bool>& bends) {
        std::vector<Sample> samples;
        std::vector<bool> again;
        for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
            const Sample &a = samples_[i], &b = samples_[i + 1];
            samples.push_back(a);
            if (!bends[i]) {
                again.push_back(false);
                continue;
            }
            Sample middle = sample(0.5 * (a.x + b.x));
            const bool bent = far_from_chord(a, middle, b);
            samples.push_back(std::move(middle));
            again.insert(again.end(), {bent, bent});
        }
        samples.push_back(samples_.back());
        samples_ = std::move(samples);
        return again;
    }

    const CurveRange& range_;
    std::size_t curves_;
    const CurvesAt& values_at_;
    std::vector<Sample> samples_;
    std::vector<double> largest_;
};

}  // namespace

SampledCurves sample_curves(const CurveRange& range, std::size_t curves, const CurvesAt& values_at) {
    return Sampler(range, curves, values_at).refined();
}

}  // namespace nacre
