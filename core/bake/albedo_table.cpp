#include "core/bake/albedo_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/bake/worst_search.h"

namespace nacre {
namespace {

// Beyond those between nodes.
constexpr int grazing_probes = 24;

// A search looks into one of `cells_each` cells, at least `cells_min`, and climbs from `climbs` points.
constexpr int cells_each = 80, cells_min = 4, climbs = 5;
constexpr int thorough_cells_each = 10, thorough_climbs = 24, comb_parts = 4;

// Directions in the layer before the horizon that it looks at.
constexpr std::size_t layer_probes = 8;

}  // namespace

AlbedoTable::AlbedoTable(const AlbedoSampling& rules, TableNodes nodes, Workers& workers)
    : rules_(rules), nodes_(nodes), channels_(rules.channels()) {
    fill(workers);
    read_ = rules.area().data();
    shading_ = rules.shading();
    place(shading_, nodes_, static_cast<int>(read_.size()));
    read_.insert(read_.end(), data_.begin(), data_.end());
    shading_.data = read_.data();
    probe(workers);
}

void AlbedoTable::fill(Workers& workers) {
    const int columns = nodes_.polar, count = columns * nodes_.azimuth;
    const FacetDistribution& distribution = *rules_.area().distribution();
    const Shading<double>& shading = rules_.shading();
    const AlbedoLayout layout = rules_.layout();
    data_.resize(static_cast<std::size_t>(count * layout.size()));
    kept_.resize(static_cast<std::size_t>(count));
    workers.for_each(count, [&](int i) {
        const int column = i % columns, row = i / columns;
        const dvec3 k = direction({static_cast<double>(column), static_cast<double>(row), TablePlace::node});
        const double g = distribution.projected_area(k), kept = shading.clamped_part(k, g);
        kept_[static_cast<std::size_t>(i)] = kept;
        AlbedoValues values = rules_.nodes()(k, g);
        for (double& value : values) value = kept > 0 ? value / kept : 0;
        const auto store = [&](int table, double value) {
            data_[static_cast<std::size_t>(i + table * count)] = static_cast<float>(value);
        };
        const auto full = [&](int c) { return values[static_cast<std::size_t>(c % layout.full())]; };
        for (int c = 0; c < layout.full(); ++c) store(c, full(c));
        const dvec3 f = channels_ == 1 ? dvec3{Shading<double>::schlick_weight(k.z)} : shading.fresnel(k.z);
        for (int c = 0; c < layout.factors(); ++c) {
            const int table = layout.full() + c;
            store(table, values[static_cast<std::size_t>(table)] - f[c] * full(c));
        }
    });
}

void AlbedoTable::probe(Workers& workers) {
    const TableCells cells = this->cells();
    const int count = rules_.most_probes();
    points_ = count < cells.count() ? cells.scattered(count) : cells.one_a_cell();
    for (const TablePoint& point : cells.grazing(grazing_probes)) points_.push_back(point);
    errors_ = sample(points_, probes_, workers);
}

TableCells AlbedoTable::cells() const { return {nodes_, rules_.area().grid().symmetry()}; }

dvec3 AlbedoTable::direction(const TablePoint& point) const {
    return rules_.area().grid().albedo_direction(point.column / (nodes_.polar - 1), point.row,
                                                 nodes_.azimuth);
}

std::vector<double> AlbedoTable::sample(const std::vector<TablePoint>& points,
                                        std::vector<KnownAlbedo>& known, Workers& workers) const {
    const FacetDistribution& distribution = *rules_.area().distribution();
    const std::size_t begin = known.size();
    known.resize(begin + points.size());
    std::vector<double> errors(points.size());
    workers.for_each(static_cast<int>(points.size()), [&](int i) {
        const std::size_t at = static_cast<std::size_t>(i);
        const dvec3 k = not_below_lowest(direction(points[at]));
        known[begin + at] = {k, rules_.probes()(k, distribution.projected_area(k))};
        errors[at] = albedo_error(shading_, k, known[begin + at].values, channels_);
    });
    return errors;
}

AxisError AlbedoTable::measure() const {
    AxisError error;
    error.all = summarise(errors_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        if (points_[i].place == TablePlace::along_polar) error.polar = worse_error(error.polar, errors_[i]);
        if (points_[i].place == TablePlace::along_azimuth)
            error.azimuth = worse_error(error.azimuth, errors_[i]);
    }
    return error;
}

void AlbedoTable::tell(std::vector<KnownAlbedo>& known) const {
    known.insert(known.end(), probes_.begin(), probes_.end());
}

// Of the table with F = 1, and of the other table that bends most beside it.
std::vector<double> AlbedoTable::cell_bends_of_all() const {
    const Symmetry symmetry = rules_.area().grid().symmetry();
    std::vector<double> bends = cell_bends(nodes_, symmetry, data_.data(), kept_);
    for (int table = 1; table < rules_.layout().size(); ++table) {
        const float* const values = data_.data() + static_cast<std::size_t>(table) * kept_.size();
        const std::vector<double> other = cell_bends(nodes_, symmetry, values, kept_);
        for (std::size_t i = 0; i < bends.size(); ++i) bends[i] = worse_error(bends[i], other[i]);
    }
    return bends;
}

// Under clamp R falls to 0 above c = g/N, which is next to the horizon where p turns away: there an error of
// g, however small beside p's width, is one of R. The points where that is largest.
std::vector<TablePoint> AlbedoTable::layer_points(Workers& workers) const {
    const TableCells cells = this->cells();
    if (cells.flat() || !shading_.kinds.clamp) return {};
    const FacetDistribution& distribution = *rules_.area().distribution();
    // Twice in each cell of either table.
    const int area_rows = azimuth_cells(shading_.surface.tables.nodes_psi, rules_.area().grid().symmetry());
    const int places = 2 * std::max(cells.rows(), area_rows);
    std::vector<std::pair<double, TablePoint>> layer(static_cast<std::size_t>(places));
    workers.for_each(places, [&](int i) {
        TablePoint point{static_cast<double>(cells.columns()), (i + 0.5) * cells.rows() / places,
                         TablePlace::centre};
        const dvec3 horizon = direction(point);
        dvec3 edge = horizon;
        double wrong = 0;  // of g there, as a part
        // From g at the horizon, then from g so high.
        for (int round = 0; round < 2; ++round) {
            const double g = distribution.projected_area(edge);
            const double read = shading_.projected_area(edge, shading_.table_spot(edge));
            const double most = std::max(g, read), c = std::max(most / shading_.surface.N, lowest_cosine);
            if (!(c < 0.5)) return;
            const double sine = std::sqrt((1 - c) * (1 + c));
            edge = {sine * horizon.x, sine * horizon.y, c};
            wrong = std::fabs(g - read) / most;
        }
        const auto albedo = shading_.albedo_spot(edge, shading_.table_spot(edge));
        point.column = albedo.v * cells.columns();
        layer[static_cast<std::size_t>(i)] = {wrong * shading_.albedo_f1(albedo), point};
    });
    std::stable_sort(layer.begin(), layer.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<TablePoint> points;
    for (const auto& [wrong, point] : layer) {
        if (points.size() == layer_probes || !(wrong > 0)) break;
        const double row = point.row;
        const auto near = [row](const TablePoint& other) { return std::fabs(other.row - row) < 0.5; };
        if (std::ranges::none_of(points, near)) points.push_back(point);
    }
    return points;
}

void AlbedoTable::search(double enough, Search how, AxisError& error, std::vector<KnownAlbedo>& known,
                         Workers& workers) const {
    const TableCells cells = this->cells();
    const std::size_t first = known.size();
    const bool thorough = how == Search::thorough;
    WorstSearch search(cells,
                       [&](const std::vector<TablePoint>& points) { return sample(points, known, workers); });
    search.look_at_bends(cell_bends_of_all(),
                         std::max(cells.count() / (thorough ? thorough_cells_each : cells_each), cells_min),
                         thorough || cells.count() > rules_.most_probes());
    search.look_at(layer_points(workers));
    search.look_at(cells.near_horizon());
    if (thorough) search.look_at(cells.beside_horizon(comb_parts));
    search.know(points_, errors_);
    if (search.worst() > enough) search.climb(thorough ? thorough_climbs : climbs);
    search.add_to(error);
    error.all.directions += static_cast<int>(known.size() - first);
}

double AlbedoTable::worst_at(const std::vector<KnownAlbedo>& known) const {
    double worst = 0;
    for (const KnownAlbedo& albedo : known)
        worst = worse_error(worst, albedo_error(shading_, albedo.k, albedo.values, channels_));
    return worst;
}

std::vector<dvec3> AlbedoTable::worst_of(const std::vector<KnownAlbedo>& known, std::size_t count) const {
    std::vector<std::pair<double, dvec3>> errors;
    for (const KnownAlbedo& albedo : known)
        errors.push_back({albedo_error(shading_, albedo.k, albedo.values, channels_), albedo.k});
    std::stable_sort(errors.begin(), errors.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<dvec3> worst;
    for (std::size_t i = 0; i < std::min(errors.size(), count); ++i) worst.push_back(errors[i].second);
    return worst;
}

void AlbedoTable::place(Shading<double>& shading, TableNodes nodes, int offset) {
    auto& shape = shading.surface.tables;
    shape.nodes_v = nodes.polar;
    shape.nodes_rho = nodes.azimuth;
    shape.albedo_offset = offset;
    const AlbedoLayout layout{0, shading.kinds.tint};
    shape.residual_offset = offset + layout.full() * nodes.polar * nodes.azimuth;
}

}  // namespace nacre
