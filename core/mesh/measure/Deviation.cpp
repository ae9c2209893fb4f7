// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/measure/Deviation.h"

#include "base/NumberText.h"
#include "mesh/search/LargestDistance.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshErrors.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace handwheel {
namespace {

constexpr double kLargestMeasured = 1e60;  // areas times squares, and their sums, stay finite
constexpr std::size_t kBlock = 256;        // queries between two polls of the cancel flag

struct Measured {
  double distance = 0.0;
  double weight = 0.0;  // mm²
};

// Calls work(i) for each i < n, on all threads of the arena. Returns false if cancelled.
template <class Work>
bool forAll(std::size_t n, const Progress& progress, Work work) {
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, kBlock), [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      if ((i - range.begin()) % kBlock == 0 && progress.cancelled()) return;
      work(i);
    }
    progress.set(static_cast<double>(done += range.size()) / static_cast<double>(n));
  });
  return !progress.cancelled();
}

// Points spread over a surface, equally many on equal areas: the same ones every time.
class Spread {
 public:
  Spread(const SurfaceDistance& surface, std::size_t count, const Progress& progress)
      : m_surface(surface), m_count(count) {
    const std::vector<Face>& faces = surface.faces();
    m_areaUpTo.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (!pollProgress(i, faces.size(), progress)) return;
      m_area += areaOf(surface.mesh().points(faces[i]));
      m_areaUpTo.push_back(m_area);
    }
    if (!(m_area > 0.0)) m_count = 0;
  }

  std::size_t count() const { return m_count; }
  double area() const { return m_area; }

  // Within a face by Roberts' R2 sequence ("The unreasonable effectiveness of quasirandom sequences", 2018), folded
  // from the square into the triangle.
  Vec3 point(std::size_t i) const {
    const double k = static_cast<double>(i), share = (k + 0.5) / static_cast<double>(m_count);
    const auto at = std::upper_bound(m_areaUpTo.begin(), m_areaUpTo.end(), share * m_area);
    const auto index = std::min(static_cast<std::size_t>(at - m_areaUpTo.begin()), m_areaUpTo.size() - 1);
    const TrianglePoints t = m_surface.mesh().points(m_surface.faces()[index]);
    constexpr double kPlastic = 1.32471795724474602596;  // x³ = x + 1
    double unused = 0.0;
    double u = std::modf(0.5 + k / kPlastic, &unused), v = std::modf(0.5 + k / (kPlastic * kPlastic), &unused);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
  }

 private:
  const SurfaceDistance& m_surface;
  std::size_t m_count;
  double m_area = 0.0;
  std::vector<double> m_areaUpTo;  // and with each face
};

// Returns a third of the area around each vertex of the surface; NaN for the other vertices, 1 if no face has an area.
std::vector<double> vertexWeights(const SurfaceDistance& surface, double area, const Progress& progress) {
  std::vector<double> weights(surface.mesh().vertexSlots(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < surface.faces().size(); ++i) {
    if (!pollProgress(i, surface.faces().size(), progress)) break;
    const Face f = surface.faces()[i];
    const double share = area > 0.0 ? areaOf(surface.mesh().points(f)) / 3.0 : 0.0;
    for (const Vertex v : surface.mesh().triangle(f)) {
      if (std::isnan(weights[v])) weights[v] = area > 0.0 ? 0.0 : 1.0;
      weights[v] += share;
    }
  }
  return weights;
}

// The distances of one surface from another.
class Measurement {
 public:
  Measurement(const SurfaceDistance& of, const SurfaceDistance& to, const DeviationOptions& options, Progress progress)
      : m_of(of), m_to(to), m_bins(options.bins), m_spread(of, options.samples, progress.part(0.0, 0.02)) {
    m_result.area = m_spread.area();
    m_result.samples = m_spread.count();
    const bool done = measureVertices(progress.part(0.02, 0.3)) && measureSamples(progress.part(0.3, 0.95));
    if (done) summarise(progress.part(0.95, 1.0));
  }

  SurfaceDeviation result() && { return std::move(m_result); }

 private:
  bool measureVertices(const Progress& progress) {
    const std::vector<double> weights = vertexWeights(m_of, m_spread.area(), progress.part(0.0, 0.1));
    std::vector<double>& distances = m_result.atVertex;
    distances.assign(weights.size(), std::numeric_limits<double>::quiet_NaN());
    const bool done = forAll(weights.size(), progress.part(0.1, 0.9), [&](std::size_t v) {
      if (!std::isnan(weights[v])) distances[v] = m_to.from(m_of.mesh().position(static_cast<Vertex>(v)))->distance;
    });
    if (!done) return false;
    for (std::size_t v = 0; v < weights.size(); ++v) {
      if (!pollProgress(v, weights.size(), progress.part(0.9, 1.0))) return false;
      if (std::isnan(weights[v])) continue;
      ++m_result.vertices;
      offer(distances[v], v);
      if (m_spread.count() == 0) m_measured.push_back({distances[v], weights[v]});
    }
    return true;
  }

  bool measureSamples(const Progress& progress) {
    const std::size_t n = m_spread.count();
    if (n == 0) return !progress.cancelled();
    m_measured.resize(n);
    const double weight = m_spread.area() / static_cast<double>(n);
    const bool done = forAll(n, progress, [&](std::size_t i) {
      m_measured[i] = {m_to.from(m_spread.point(i))->distance, weight};
    });
    if (!done) return false;
    for (std::size_t i = 0; i < n; ++i) offer(m_measured[i].distance, m_result.atVertex.size() + i);
    return true;
  }

  // Indices count vertex slots first, then samples.
  void offer(double distance, std::size_t index) {
    if (distance < m_lowest.first) m_lowest = {distance, index};
    if (distance > m_highest.first) m_highest = {distance, index};
  }

  DeviationExtremum at(std::size_t index) const {
    const std::size_t slots = m_result.atVertex.size();
    const Vec3 p = index < slots ? m_of.mesh().position(static_cast<Vertex>(index)) : m_spread.point(index - slots);
    const auto nearest = m_to.from(p);
    return {nearest->distance, p, nearest->point};
  }

  void summarise(const Progress& progress) {
    m_result.lowest = at(m_lowest.second);
    m_result.highest = at(m_highest.second);
    const double low = m_result.lowest.distance, width = m_result.highest.distance - low;
    m_result.histogram.assign(m_bins, 0.0);
    double total = 0.0, sum = 0.0, absolute = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < m_measured.size(); ++i) {
      if (!pollProgress(i, m_measured.size(), progress.part(0.0, 0.5))) return;
      const auto [d, weight] = m_measured[i];
      total += weight;
      sum += weight * d;
      absolute += weight * std::abs(d);
      squares += weight * d * d;
      const double at = width > 0.0 ? (d - low) / width * static_cast<double>(m_bins) : 0.0;
      m_result.histogram[std::min(static_cast<std::size_t>(at), m_bins - 1)] += weight;
    }
    for (double& share : m_result.histogram) share /= total;
    m_result.mean = sum / total;
    m_result.meanAbsolute = absolute / total;
    m_result.rms = std::sqrt(squares / total);
    takePercentiles(total, progress);
  }

  // Weighted medians by halving (Bleich and Overton, "A linear-time algorithm for the weighted median problem", 1983):
  // no step takes longer than one pass, whereas a sort would not notice a cancel in time.
  void takePercentiles(double total, const Progress& progress) {
    for (Measured& m : m_measured) m.distance = std::abs(m.distance);
    const auto isLess = [](const Measured& a, const Measured& b) { return a.distance < b.distance; };
    auto from = m_measured.begin();  // those before it are nearer, and weigh so much
    double before = 0.0;
    for (std::size_t i = 0; i < kDeviationPercentiles.size(); ++i) {
      const double wanted = 0.01 * kDeviationPercentiles[i] * total;
      for (auto to = m_measured.end(); to - from > 1;) {
        if (progress.cancelled()) return;
        const auto middle = from + (to - from) / 2;
        std::nth_element(from, middle, to, isLess);
        const double nearer =
            std::accumulate(from, middle, before, [](double w, const Measured& m) { return w + m.weight; });
        if (nearer >= wanted) {
          to = middle;
        } else {
          from = middle;
          before = nearer;
        }
      }
      m_result.percentiles[i] = from->distance;
    }
  }

  const SurfaceDistance& m_of;
  const SurfaceDistance& m_to;
  std::size_t m_bins;
  Spread m_spread;
  std::vector<Measured> m_measured;  // values from which the statistics are computed
  std::pair<double, std::size_t> m_lowest{std::numeric_limits<double>::infinity(), 0};
  std::pair<double, std::size_t> m_highest{-std::numeric_limits<double>::infinity(), 0};
  SurfaceDeviation m_result;
};

Status check(const SurfaceDistance& surface) {
  if (surface.empty()) return Error{MeshError::NoTriangles, {}, {}, {}};
  const Box& box = surface.hierarchy().bounds();
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (largest <= kLargestMeasured) return Done{};
  return Error{ErrorCode::ValueOutOfRange,
               {"coordinate", shortestText(largest), shortestText(-kLargestMeasured), shortestText(kLargestMeasured)},
               {},
               {}};
}

}  // namespace

double Deviation::hausdorff() const {
  return std::max(std::abs(ofMesh.farthest().distance), std::abs(ofScan.farthest().distance));
}

Result<Deviation> deviation(const HalfEdgeMesh& mesh, const HalfEdgeMesh& scan, const DeviationOptions& options,
                            Progress progress) {
  const SurfaceDistance a(mesh, progress.part(0.0, 0.1)), b(scan, progress.part(0.1, 0.2));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return deviation(a, b, options, progress.part(0.2, 1.0));
}

Result<Deviation> deviation(const SurfaceDistance& mesh, const SurfaceDistance& scan, const DeviationOptions& options,
                            Progress progress) {
  assert(options.bins >= 1 && options.bins <= kMaxDeviationBins && options.samples <= kMaxDeviationSamples);
  for (const SurfaceDistance* surface : {&mesh, &scan}) {
    if (const Status status = check(*surface); !status) return status.error();
  }
  Deviation result;
  const double measured = options.measuresBound ? 0.7 : 1.0;
  result.ofMesh = Measurement(mesh, scan, options, progress.part(0.0, 0.5 * measured)).result();
  result.ofScan = Measurement(scan, mesh, options, progress.part(0.5 * measured, measured)).result();
  if (options.measuresBound) result.atMost = largestDistance(mesh, scan, progress.part(measured, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return result;
}

}  // namespace handwheel
