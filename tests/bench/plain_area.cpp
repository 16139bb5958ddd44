#include "tests/bench/plain_area.h"

#include <algorithm>

namespace nacre::bench {
namespace {

constexpr std::size_t block = 2048;    // facets that are summed at a time
constexpr std::size_t directions = 4;  // that share one pass over a block

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define EVERY_VECTOR_WIDTH [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define EVERY_VECTOR_WIDTH
#endif

template <class Real>
struct Rows {
    const Real* __restrict x;
    const Real* __restrict y;
    const Real* __restrict z;
};

template <class Real>
[[gnu::always_inline]] inline void add_block(Rows<Real> facets, const Real (&k)[3][directions],
                                             double (&g)[directions]) {
    Real a = 0, b = 0, c = 0, d = 0;
#pragma omp simd reduction(+ : a, b, c, d)
    for (std::size_t i = 0; i < block; ++i) {
        const Real x = facets.x[i], y = facets.y[i], z = facets.z[i];
        const Real s0 = x * k[0][0] + y * k[1][0] + z * k[2][0];
        const Real s1 = x * k[0][1] + y * k[1][1] + z * k[2][1];
        const Real s2 = x * k[0][2] + y * k[1][2] + z * k[2][2];
        const Real s3 = x * k[0][3] + y * k[1][3] + z * k[2][3];
        a += s0 > 0 ? s0 : 0;
        b += s1 > 0 ? s1 : 0;
        c += s2 > 0 ? s2 : 0;
        d += s3 > 0 ? s3 : 0;
    }
    g[0] += static_cast<double>(a);
    g[1] += static_cast<double>(b);
    g[2] += static_cast<double>(c);
    g[3] += static_cast<double>(d);
}

EVERY_VECTOR_WIDTH void add(Rows<float> facets, const float (&k)[3][directions], double (&g)[directions]) {
    add_block(facets, k, g);
}

EVERY_VECTOR_WIDTH void add(Rows<double> facets, const double (&k)[3][directions], double (&g)[directions]) {
    add_block(facets, k, g);
}

}  // namespace

template <class Real>
PlainArea<Real>::PlainArea(const std::vector<Facet>& facets) {
    const std::size_t size = (facets.size() + block - 1) / block * block;
    for (std::vector<Real>* row : {&x_, &y_, &z_}) row->resize(size);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const glm::vec<3, Real> moment(facets[i].mass * facets[i].h);
        x_[i] = moment.x;
        y_[i] = moment.y;
        z_[i] = moment.z;
    }
}

template <class Real>
void PlainArea<Real>::operator()(std::span<const dvec3> k, std::span<double> g) const {
    for (std::size_t begin = 0; begin < k.size(); begin += directions) {
        const std::size_t count = std::min(directions, k.size() - begin);
        Real part[3][directions]{};
        for (std::size_t j = 0; j < count; ++j)
            for (int axis = 0; axis < 3; ++axis) part[axis][j] = static_cast<Real>(k[begin + j][axis]);
        double sum[directions]{};
        for (std::size_t i = 0; i < x_.size(); i += block)
            add(Rows<Real>{x_.data() + i, y_.data() + i, z_.data() + i}, part, sum);
        std::copy_n(sum, count, g.begin() + static_cast<std::ptrdiff_t>(begin));
    }
}

template class PlainArea<float>;
template class PlainArea<double>;

}  // namespace nacre::bench
