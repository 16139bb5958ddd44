#include "core/study/accuracy.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "core/bake/bake.h"
#include "core/design/design_check.h"
#include "core/study/cold_time.h"
#include "core/study/method.h"
#include "core/verify/reference.h"
#include "core/verify/table_error.h"

namespace nacre {
namespace {

// The exact g and R on the probes, and the divisors of area_error().
class Truth {
  public:
    Truth(const Design& design, const AccuracyOptions& options, const std::stop_token& stop)
        : tables_(bake(design, {.threads = 1}, stop)),
          area_probes_(probe_directions(options.area_probes)),
          albedo_probes_(probe_directions(options.albedo_probes)) {
        const Reference reference(design);
        for (const dvec3 k : area_probes_) area_.push_back(reference.projected_area(k));
        albedo_.resize(albedo_probes_.size());
        tbb::parallel_for(std::size_t{0}, albedo_probes_.size(), [&](std::size_t i) {
            if (stop.stop_requested()) throw BakeCancelled();
            albedo_[i] = reference.albedo(albedo_probes_[i], stop);
        });
    }

    TableError area_error_of(const StoredTable& table) const {
        std::vector<double> errors;
        for (std::size_t i = 0; i < area_.size(); ++i)
            errors.push_back(
                area_error(tables_->shading, area_probes_[i], table.area(area_probes_[i]), area_[i]));
        return summarise(errors);
    }

    // With F = 1, then with f0 = 0.
    TableError albedo_error_of(const StoredTable& table, std::size_t factor) const {
        std::vector<double> errors;
        for (std::size_t i = 0; i < albedo_.size(); ++i)
            errors.push_back(std::fabs(table.albedo(albedo_probes_[i])[factor] - albedo_[i][factor]));
        return summarise(errors);
    }

  private:
    std::shared_ptr<const Tables> tables_;
    std::vector<dvec3> area_probes_, albedo_probes_;
    std::vector<double> area_;
    std::vector<AlbedoValues> albedo_;
};

class AccuracyRun {
  public:
    AccuracyRun(const Design& design, const AccuracyOptions& options, std::stop_token stop,
                const std::function<void(double)>& progress)
        : options_(options), stop_(std::move(stop)), progress_(progress), specular_(design) {
        specular_.fresnel = SchlickFresnel{};
        specular_.diffuse = NoDiffuse{};
        for (Layer& layer : specular_.distribution.layers) layer.tint = dvec3{1};
    }

    std::vector<MethodAccuracy> run() {
        const Truth truth(specular_, options_, stop_);
        report(0.1);
        const std::vector<Method> methods = all_methods(specular_, stop_);
        std::vector<MethodAccuracy> result;
        const double step = 0.7 / (2.0 * static_cast<double>(methods.size()));
        double done = 0.1;
        for (const Method& method : methods) {
            result.push_back({method.kind, method.name, method.about, {}, method.left_out});
            for (const Wanted wanted : {Wanted::area, Wanted::area_and_albedo}) {
                const bool serves = wanted == Wanted::area ? method.area : method.albedo;
                if (serves)
                    measure(method, wanted, truth, result.back().points,
                            [&](double part) { report(done + step * part); });
                report(done += step);
            }
        }
        return result;
    }

  private:
    void report(double done) const {
        if (stop_.stop_requested()) throw BakeCancelled();
        if (progress_) progress_(done);
    }

    void measure(const Method& method, Wanted wanted, const Truth& truth, std::vector<AccuracyPoint>& points,
                 const std::function<void(double)>& inner) const {
        for (const MethodSetting& setting : method.settings) {
            const auto timed = time_from_cold([&] { return setting.make(wanted, stop_); });
            const StoredTable& table = timed.result;
            auto add = [&](Quantity quantity, const TableError& error) {
                points.push_back({setting.label, quantity, timed.seconds, table.bytes, error});
            };
            if (wanted == Wanted::area) {
                add(Quantity::area, truth.area_error_of(table));
            } else {
                add(Quantity::albedo_f1, truth.albedo_error_of(table, 0));
                add(Quantity::albedo_f0, truth.albedo_error_of(table, 1));
            }
            if (timed.seconds > options_.longest) return;
            inner(static_cast<double>(&setting - method.settings.data() + 1) /
                  static_cast<double>(method.settings.size()));
        }
    }

    AccuracyOptions options_;
    std::stop_token stop_;
    const std::function<void(double)>& progress_;
    Design specular_;
};

}  // namespace

const char* name_of(Quantity quantity) {
    switch (quantity) {
        case Quantity::area:
            return "g";
        case Quantity::albedo_f1:
            return "R1";
        case Quantity::albedo_f0:
            return "R0";
    }
    return "";
}

DesignAccuracy measure_accuracy(const Design& design, const AccuracyOptions& options, std::stop_token stop,
                                const std::function<void(double)>& progress) {
    DesignAccuracy accuracy;
    accuracy.name = design.name;
    accuracy.energy_note = energy_note(design.specular.intensity);
    accuracy.symmetry = find_symmetry(design.distribution).symmetry;
    accuracy.methods = AccuracyRun(design, options, stop, progress).run();
    accuracy.costs = measure_omissions(design, stop);
    if (progress) progress(1);
    return accuracy;
}

}  // namespace nacre
