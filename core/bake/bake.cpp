#include "core/bake/bake.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/bake/albedo.h"
#include "core/bake/coupling.h"
#include "core/bake/stretched_grid.h"
#include "core/model/surface.h"

namespace nacre {
namespace {

// A final bake doubles its nodes until g is closer than this part of the tolerance between them, or the
// tables reach the limit.
constexpr double kept_tolerance = 0.7;
constexpr int nodes_limit = 20000;

class Bake {
  public:
    Bake(const Design& design, const BakeOptions& options, std::stop_token stop,
         const std::function<void(double)>& progress)
        : design_(design),
          options_(options),
          stop_(std::move(stop)),
          progress_(progress),
          arena_(options.threads > 0 ? std::min(options.threads, tbb::info::default_concurrency())
                                     : tbb::task_arena::automatic),
          tables_(std::make_shared<Tables>()) {
        tables_->tolerance = options.tolerance;
        tables_->plan = plan_bake(design, {options.quality, options.albedo, options.size, options.symmetry});
    }

    std::shared_ptr<const Tables> run() {
        const auto begin = std::chrono::steady_clock::now();
        tables_->distribution = std::make_shared<FacetDistribution>(design_.distribution);
        tables_->mean = tables_->distribution->mean();
        describe_material(design_, *tables_->distribution, tables_->shading);
        tables_->shading.kinds.albedo = tables_->plan.albedo;
        bake_area();
        if (tables_->plan.quality == Quality::final && !options_.size) {
            while (tables_->errors.area.worst > kept_tolerance * options_.tolerance && refine()) bake_area();
        }
        report(0.3);
        if (tables_->plan.albedo) bake_albedo();
        describe_layers(design_.distribution, *tables_->distribution, tables_->shading, tables_->data);
        tables_->shading.data = tables_->data.data();
        report(1);
        tables_->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return tables_;
    }

  private:
    void report(double done) const {
        if (stop_.stop_requested()) throw BakeCancelled();
        if (progress_) progress_(done);
    }

    // Calls visit(i) for every i; results must not depend on order.
    template <class Visit>
    void for_each(int count, const Visit& visit) {
        arena_.execute([&] {
            tbb::parallel_for(0, count, [&](int i) {
                if (!stop_.stop_requested()) visit(i);
            });
        });
        if (stop_.stop_requested()) throw BakeCancelled();
    }

    // Doubles the nodes along the axis that errs more; false at the limit.
    bool refine() {
        BakePlan& plan = tables_->plan;
        const bool along_w = plan.symmetry.symmetry == Symmetry::isotropic || error_w_ >= error_psi_;
        const int w = along_w ? 2 * plan.nodes.w - 1 : plan.nodes.w;
        const int psi = along_w ? plan.nodes.psi
                                : 2 * plan.nodes.psi - (plan.symmetry.symmetry == Symmetry::none ? 0 : 1);
        if (w * psi > nodes_limit) return false;
        plan.nodes.w = w;
        plan.nodes.psi = psi;
        return true;
    }

    void bake_area() {
        const BakePlan& plan = tables_->plan;
        const StretchedGrid grid(*tables_->distribution, plan);
        const int columns = plan.nodes.w, rows = plan.nodes.psi;
        std::vector<float>& data = tables_->data;
        auto& shape = tables_->shading.surface.tables;
        data = grid.widths();
        shape = grid.shape();
        shape.nodes_w = columns;
        shape.nodes_v = plan.nodes.v;
        shape.nodes_rho = plan.nodes.rho;
        shape.width_offset = 0;
        shape.area_offset = rows;
        data.resize(static_cast<std::size_t>(rows + rows * columns));
        for_each(rows * columns, [&](int i) {
            const double w = static_cast<double>(i % columns) / (columns - 1);
            const int row = i / columns;
            const double g = tables_->distribution->area(grid.area_direction(w, row)).g;
            data[static_cast<std::size_t>(rows + i)] = static_cast<float>(grid.shape_value(w, row, g));
        });
        tables_->shading.data = data.data();
        measure_area(grid);
    }

    double error_at(const StretchedGrid& grid, double w, double row) const {
        const dvec3 k = grid.area_direction(w, row);
        return area_error(tables_->shading, k, tables_->distribution->area(k).g);
    }

    // Between all nodes: at the middles of both kinds of edges and at the centres of cells.
    void measure_area(const StretchedGrid& grid) {
        const int columns = tables_->plan.nodes.w - 1, rows = std::max(1, tables_->plan.nodes.psi - 1);
        const int count = columns * rows;
        std::vector<dvec3> errors(static_cast<std::size_t>(count));
        for_each(count, [&](int i) {
            const double column = i % columns, row = i / columns;
            dvec3& error = errors[static_cast<std::size_t>(i)];
            error.x = error_at(grid, (column + 0.5) / columns, row);
            if (tables_->plan.nodes.psi == 1) return;
            error.y = error_at(grid, (column + 1) / columns, row + 0.5);
            error.z = error_at(grid, (column + 0.5) / columns, row + 0.5);
        });
        TableError& error = tables_->errors.area;
        error = {.directions = tables_->plan.nodes.psi == 1 ? count : 3 * count};
        error_w_ = error_psi_ = 0;
        for (const dvec3& e : errors) {
            error_w_ = std::fmax(error_w_, e.x);
            error_psi_ = std::fmax(error_psi_, e.y);
            error.worst = std::fmax(error.worst, std::fmax(e.x, std::fmax(e.y, e.z)));
            error.root_mean_square += glm::dot(e, e) / error.directions;
        }
        error.root_mean_square = std::sqrt(error.root_mean_square);
    }

    void bake_albedo() {
        const BakePlan& plan = tables_->plan;
        const StretchedGrid grid(*tables_->distribution, plan);
        const AlbedoRule rule(*tables_->distribution, plan.quality == Quality::final);
        const int columns = plan.nodes.v, rows = plan.nodes.rho, size = rows * columns;
        const int channels = plan.fresnel_tables;
        Shading<double>& shading = tables_->shading;
        std::vector<float> albedo(static_cast<std::size_t>(size * (1 + channels)));
        for (int row = 0; row < rows; ++row) {
            for_each(columns, [&](int column) {
                const dvec3 k = grid.albedo_direction(static_cast<double>(column) / (columns - 1), row);
                const double g = tables_->distribution->area(k).g;
                AlbedoValues values = rule(shading, k, g, channels);
                const double kept = shading.clamped_part(k, g);
                for (double& value : values) value = kept > 0 ? value / kept : 0;
                const int i = row * columns + column;
                albedo[static_cast<std::size_t>(i)] = static_cast<float>(values[0]);
                const dvec3 f =
                    channels == 1 ? dvec3{Shading<double>::schlick_weight(k.z)} : shading.fresnel(k.z);
                for (int c = 0; c < channels; ++c)
                    albedo[static_cast<std::size_t>(i + (c + 1) * size)] =
                        static_cast<float>(values[static_cast<std::size_t>(c + 1)] - f[c] * values[0]);
            });
            report(0.3 + 0.6 * (row + 1) / rows);
        }
        std::vector<float>& data = tables_->data;
        shading.surface.tables.albedo_offset = static_cast<int>(data.size());
        shading.surface.tables.residual_offset = static_cast<int>(data.size()) + size;
        data.insert(data.end(), albedo.begin(), albedo.end());
        shading.data = data.data();
        const AlbedoIntegrals integrals = integrate_albedo(shading);
        tables_->mean_albedo = integrals.mean;
        shading.surface.coupling = integrals.coupling;
    }

    const Design& design_;
    const BakeOptions options_;
    std::stop_token stop_;
    const std::function<void(double)>& progress_;
    tbb::task_arena arena_;
    std::shared_ptr<Tables> tables_;
    double error_w_ = 0, error_psi_ = 0;  // worst error of g between nodes along one axis alone
};

}  // namespace

std::size_t Tables::table_floats() const {
    const std::size_t rows = static_cast<std::size_t>(plan.nodes.psi);
    const std::size_t albedos = plan.albedo ? 1 + static_cast<std::size_t>(plan.fresnel_tables) : 0;
    const std::size_t albedo =
        static_cast<std::size_t>(plan.nodes.rho) * static_cast<std::size_t>(plan.nodes.v);
    return rows * (1 + static_cast<std::size_t>(plan.nodes.w)) + albedos * albedo;
}

double area_error(const Shading<double>& shading, dvec3 k, double exact) {
    return area_error(shading, k, shading.projected_area(k, shading.table_spot(k)), exact);
}

double area_error(const Shading<double>& shading, dvec3 k, double read, double exact) {
    const double floor = shading.kinds.clamp ? shading.surface.N * k.z : 0;
    const double divisor = std::max({exact, floor, 0.05 * shading.table_spot(k).q});
    return divisor > 0 ? std::fabs(std::fmax(read, floor) - std::fmax(exact, floor)) / divisor : 0;
}

std::shared_ptr<const Tables> bake(const Design& design, const BakeOptions& options, std::stop_token stop,
                                   const std::function<void(double)>& progress) {
    return Bake(design, options, std::move(stop), progress).run();
}

}  // namespace nacre
