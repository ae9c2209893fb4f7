// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/IntersectionClusters.h"

#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <limits>
#include <map>
#include <span>

namespace handwheel {
namespace {

using Cluster = std::vector<Face>;

// The divisor of the remaining effort that limits one trial, if there are others.
constexpr std::size_t kClusterTrialShare = 4;

class ClusterResolver {
 public:
  ClusterResolver(HalfEdgeMesh& mesh, NumberType numbers, bool isOne, Progress progress)
      : m_mesh(mesh),
        m_numbers(numbers),
        m_isOne(isOne),
        m_effort(progress.share(std::numeric_limits<std::size_t>::max())),
        m_progress(progress.measuredBy(m_effort)),
        m_badEdges(countBadEdges(mesh, m_progress)) {}

  void take(std::span<const Cluster> some) {
    m_result.isCutShort = m_result.isCutShort || (!some.empty() && m_effort.isSpent());
    if (some.empty() || m_progress.cancelled()) return;
    WorkBudget effort = m_progress.share(m_effort.left() / (m_isOne ? 1 : kClusterTrialShare));
    if (tryTogether(some, m_progress.within(effort))) {
      m_result.clusters += some.size();
      return;
    }
    if (some.size() == 1) {
      m_result.isCutShort = m_result.isCutShort || effort.isSpent();
      return;
    }
    take(some.first(some.size() / 2));
    take(some.subspan(some.size() / 2));
  }

  const ClusterRemoval& result() const { return m_result; }

 private:
  bool tryTogether(std::span<const Cluster> some, const Progress& now) {
    Cluster faces;
    for (const Cluster& cluster : some) faces.insert(faces.end(), cluster.begin(), cluster.end());
    HalfEdgeMesh changed = m_mesh;
    if (!removeAllSelfIntersections(changed, faces, m_numbers, now).changed) return false;
    const std::size_t badEdges = countBadEdges(changed, now);
    if (badEdges > m_badEdges || now.cancelled()) return false;
    m_badEdges = badEdges;
    m_mesh = std::move(changed);
    return true;
  }

  HalfEdgeMesh& m_mesh;
  NumberType m_numbers;
  bool m_isOne;  // there is only one cluster
  WorkBudget m_effort;
  Progress m_progress;
  std::size_t m_badEdges;  // number in the mesh as the file will store it
  ClusterRemoval m_result;
};

}  // namespace

std::vector<std::vector<Face>> intersectionClusters(const std::vector<std::pair<Face, Face>>& pairs) {
  std::map<Face, Face> root;
  const auto find = [&](Face f) {
    Face top = root.emplace(f, f).first->second;
    while (root[top] != top) top = root[top] = root[root[top]];
    return root[f] = top;
  };
  for (const auto& [a, b] : pairs) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    root[high] = low;
  }
  std::map<Face, Cluster> clusters;
  for (const auto& entry : std::map(root)) clusters[find(entry.first)].push_back(entry.first);
  std::vector<Cluster> sorted;
  sorted.reserve(clusters.size());
  for (auto& entry : clusters) sorted.push_back(std::move(entry.second));
  return sorted;
}

ClusterRemoval removeClusterIntersections(HalfEdgeMesh& mesh, const std::vector<std::pair<Face, Face>>& pairs,
                                          NumberType numbers, Progress progress) {
  const std::vector<Cluster> clusters = intersectionClusters(pairs);
  ClusterResolver remover(mesh, numbers, clusters.size() == 1, progress);
  remover.take(clusters);
  return remover.result();
}

}  // namespace handwheel
