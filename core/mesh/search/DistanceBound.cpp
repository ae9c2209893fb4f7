// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/DistanceBound.h"

#include "proximity/ClosestPoint.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

namespace handwheel {
namespace {

constexpr std::size_t kFacesPerBlock = 64;
constexpr std::size_t kMostParts = 20'000'000;  // some 20 s of one processor
constexpr std::size_t kMostPartsOfFace = 64;    // average limit for larger meshes
constexpr int kMostCuts = 16;                   // subdivision depth of a face: parts of 1 / 65,536 of its length
constexpr std::size_t kPartsPerLook = 1024;

class Proof {
 public:
  Proof(const TriangleHierarchy& of, double distance, bool isForAll, std::size_t faces, const Progress& progress)
      : m_of(of),
        m_mostParts(std::max(kMostParts, kMostPartsOfFace * faces)),
        m_distance(distance),
        m_near(distance / (1.0 + kBoundSlack)),
        m_isForAll(isForAll),
        m_progress(progress) {}

  bool isOver() const { return (m_isRefuted && !m_isForAll) || m_isGivenUp; }
  std::vector<Vec3> takeBeyond() {
    std::sort(m_beyond.begin(), m_beyond.end(), [](const Vec3& a, const Vec3& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    return std::move(m_beyond);
  }
  Within result() const { return m_isRefuted ? Within::No : m_isGivenUp ? Within::Unknown : Within::Yes; }

  // looked counts the parts since the last poll, of this face and of previous ones.
  void take(const TrianglePoints& face, std::size_t& looked) {
    struct Part {
      TrianglePoints corners;
      int cuts;
    };
    std::vector<Part> parts{{face, 0}};
    while (!parts.empty()) {
      if (++looked == kPartsPerLook && !poll(looked)) return;
      const auto [t, cuts] = parts.back();
      parts.pop_back();
      const Judgement judgement = judge(t);
      if (judgement == Judgement::Near) continue;
      if (judgement == Judgement::Far) return;
      if (cuts == kMostCuts) m_isGivenUp = true;
      if (isOver()) return;
      const Vec3 ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
      for (const TrianglePoints& part : {TrianglePoints{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}}) {
        parts.push_back({part, cuts + 1});
      }
    }
  }

  bool poll(std::size_t& looked) {
    if ((m_parts += std::exchange(looked, 0)) > m_mostParts || m_progress.cancelled()) m_isGivenUp = true;
    return !isOver();
  }

 private:
  enum class Judgement { Near, Far, Unclear };

  Judgement judge(const TrianglePoints& part) {
    const Vec3 middle = (part[0] + part[1] + part[2]) / 3.0;
    const auto nearest = m_of.nearest(middle);
    const double distance = nearest ? (nearest->point - middle).norm() : 2.0 * m_distance;
    if (distance > m_near) {
      refute(middle);
      return Judgement::Far;
    }
    double reach = 0.0, farthest = 0.0;
    const auto [a, b, c] = m_of.corners(nearest->triangle);
    for (const Vec3& p : part) {
      reach = std::max(reach, (p - middle).norm());
      farthest = std::max(farthest, (closestOnTriangle(p, a, b, c) - p).norm());
    }
    return farthest <= m_distance || distance + reach <= m_distance ? Judgement::Near : Judgement::Unclear;
  }

  void refute(const Vec3& position) {
    m_isRefuted = true;
    if (!m_isForAll) return;
    const std::scoped_lock lock(m_mutex);
    m_beyond.push_back(position);
  }

  const TriangleHierarchy& m_of;
  std::size_t m_mostParts;
  double m_distance;
  double m_near;  // tolerance that ends the subdivision: it is no less than the size of small parts
  bool m_isForAll;
  const Progress& m_progress;
  std::atomic<std::size_t> m_parts{0};
  std::atomic<bool> m_isRefuted{false}, m_isGivenUp{false};
  std::mutex m_mutex;
  std::vector<Vec3> m_beyond;
};

}  // namespace

Within liesWithin(const SurfaceDistance& surface, const SurfaceDistance& of, double distance, Progress progress,
                  std::vector<Vec3>* beyond) {
  if (progress.cancelled()) return Within::Unknown;
  const std::size_t n = surface.faces().size();
  Proof proof(of.hierarchy(), distance, beyond != nullptr, n, progress);
  std::atomic<std::size_t> done{0};
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, n, kFacesPerBlock), [&](const Range& range) {
    std::size_t looked = 0;
    for (std::size_t i = range.begin(); i < range.end() && !proof.isOver(); ++i) {
      proof.take(surface.mesh().points(surface.faces()[i]), looked);
    }
    proof.poll(looked);
    progress.set(static_cast<double>(done += range.size()) / static_cast<double>(n));
  });
  if (beyond) *beyond = proof.takeBeyond();
  return progress.cancelled() ? Within::Unknown : proof.result();
}

}  // namespace handwheel
