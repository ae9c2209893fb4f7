// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/CrossingClusters.h"

#include "mesh/PositionTriangles.h"
#include "mesh/Uncrossing.h"

#include <algorithm>
#include <map>
#include <span>

namespace handwheel {
namespace {

using Cluster = std::vector<Face>;

// The share of the effort that one trial may take.
constexpr std::size_t kTrialShare = 4;

class ClusterUncrosser {
 public:
  ClusterUncrosser(HalfEdgeMesh& mesh, NumberType numbers, Progress progress)
      : m_mesh(mesh),
        m_numbers(numbers),
        m_effort(progress.share(tolerance::kHardHoleEffort)),
        m_progress(progress.measuredBy(m_effort)),
        m_badEdges(countBadEdges(mesh, m_progress)) {}

  void take(std::span<const Cluster> some) {
    if (some.empty() || m_progress.cancelled()) return;
    if (tryTogether(some)) {
      m_done += some.size();
      return;
    }
    if (some.size() == 1) return;
    take(some.first(some.size() / 2));
    take(some.subspan(some.size() / 2));
  }

  std::size_t done() const { return m_done; }

 private:
  bool tryTogether(std::span<const Cluster> some) {
    Cluster faces;
    for (const Cluster& cluster : some) faces.insert(faces.end(), cluster.begin(), cluster.end());
    HalfEdgeMesh changed = m_mesh;
    Effort effort = m_progress.share(m_trialEffort);
    const Progress now = m_progress.within(effort);
    if (!uncrossAll(changed, faces, m_numbers, now).changed) return false;
    const std::size_t badEdges = countBadEdges(changed, now);
    if (badEdges > m_badEdges || now.cancelled()) return false;
    m_badEdges = badEdges;
    m_mesh = std::move(changed);
    return true;
  }

  HalfEdgeMesh& m_mesh;
  NumberType m_numbers;
  Effort m_effort;
  const std::size_t m_trialEffort = m_effort.left() / kTrialShare;
  Progress m_progress;
  std::size_t m_badEdges;  // of the mesh, as the file will show it
  std::size_t m_done = 0;
};

}  // namespace

std::vector<std::vector<Face>> crossingClusters(const std::vector<std::pair<Face, Face>>& pairs) {
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

std::size_t uncrossClusters(HalfEdgeMesh& mesh, const std::vector<std::pair<Face, Face>>& pairs, NumberType numbers,
                            Progress progress) {
  ClusterUncrosser uncrosser(mesh, numbers, progress);
  uncrosser.take(crossingClusters(pairs));
  return uncrosser.done();
}

}  // namespace handwheel
