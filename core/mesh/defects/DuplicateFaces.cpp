// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/DuplicateFaces.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

// Returns true if two triangles over the same three positions have opposite orientations.
bool areOpposite(const Triangle& a, const Triangle& b) {
  const auto at = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return b[static_cast<std::size_t>((at + 1) % 3)] == a[2];
}

bool isPlate(const FaceGroup& group, const std::vector<Triangle>& triangles) {
  return group.faces.size() == 2 && areOpposite(triangles[group.faces[0]], triangles[group.faces[1]]);
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;
int direction(const Triangle& t, int k) {
  return t[k] < t[(k + 1) % 3] ? 1 : -1;
}
Edge edge(const Triangle& sorted, int k) {
  return std::minmax(sorted[k], sorted[(k + 1) % 3]);
}

// An edge of duplicates with the numbers of its groups and of its faces without duplicates.
struct Meeting {
  int groups = 0;
  int others = 0;
  int forward = 0;  // number of others that run along it from the lower position, minus those in the reverse direction
  std::uint32_t firstGroup = 0;
};

std::map<Edge, Meeting> findMeetings(const std::vector<Triangle>& triangles, const std::vector<FaceGroup>& groups,
                                     Progress progress) {
  std::map<Edge, Meeting> meetings;
  std::vector<bool> isDuplicate(triangles.size(), false);
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    if (!pollProgress(g, groups.size(), progress.part(0.0, 0.5), kSearchesPerPoll)) return meetings;
    for (const Face f : groups[g].faces) isDuplicate[f] = true;
    for (int k = 0; k < 3; ++k) {
      Meeting& m = meetings.try_emplace(edge(groups[g].positions, k), Meeting{0, 0, 0, g}).first->second;
      ++m.groups;
    }
  }
  for (Face f = 0; f < triangles.size(); ++f) {
    if (!pollProgress(f, triangles.size(), progress.part(0.5, 1.0), kSearchesPerPoll)) return meetings;
    const Triangle& t = triangles[f];
    if (hasRepeatedVertex(t) || isDuplicate[f]) continue;
    for (int k = 0; k < 3; ++k) {
      const auto at = meetings.find(edge(t, k));
      if (at == meetings.end()) continue;
      ++at->second.others;
      at->second.forward += direction(t, k);
    }
  }
  return meetings;
}

// The numbers of edges of connected duplicates that would not have two faces if none, one or two of each group stayed.
struct Choice {
  int bad[3] = {0, 0, 0};
  long open = 0;  // edges that one face of each group would leave open
  long groups = 0;
  bool standsAlone = true;  // no other face at any edge
  bool platesOnly = true;

  void count(const Meeting& m) {
    standsAlone = standsAlone && m.others == 0;
    for (int keep : {0, 1}) {
      const int n = m.others + keep * m.groups;
      bad[keep] += n != 0 && n != 2;
    }
    // Two walls in the same direction belong to overlapping bodies and do not continue each other.
    bad[0] += m.others == 2 && m.forward != 0;
    open += m.others + m.groups == 1;
    bad[2] += m.others != 0;  // the two sides of a plate pair up whatever their number
  }

  int keep() const {
    int best = 1;
    // A plate has a rim as long as a sheet's; a closed skin that was written twice has none, or a few gaps.
    if (platesOnly && open * open > groups && bad[2] < bad[best]) best = 2;
    if (!standsAlone && bad[0] < bad[best]) best = 0;
    return best;
  }
};

}  // namespace

std::vector<FaceGroup> equalFaces(std::span<const Triangle> triangles, const EdgeTable& edges, Progress progress) {
  std::vector<FaceGroup> groups;
  std::vector<std::pair<std::uint32_t, Face>> above;  // third corners beyond the edge's, with their faces
  // A triangle is searched at the edge between its two lowest positions.
  const auto collect = [&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    above.clear();
    for (const EdgeTable::Entry& e : run) {
      const std::uint32_t third = triangles[e.halfEdge / 3][(e.halfEdge + 2) % 3];
      if (third > high) above.emplace_back(third, e.halfEdge / 3);
    }
    std::sort(above.begin(), above.end());
    for (std::size_t i = 0, end = 0; i < above.size(); i = end) {
      while (end < above.size() && above[end].first == above[i].first) ++end;
      if (end - i < 2) continue;
      FaceGroup& group = groups.emplace_back(FaceGroup{{low, high, above[i].first}, {}});
      for (std::size_t k = i; k < end; ++k) group.faces.push_back(above[k].second);
    }
  };
  edges.forEachEdge(collect, progress);
  return groups;
}

std::size_t removeDuplicateFaces(HalfEdgeMesh& mesh, Progress progress, const FaceSelection* only) {
  const PositionTriangles byPosition(mesh, progress.part(0.0, 0.2));
  const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size(), progress.part(0.2, 0.4));
  const std::vector<FaceGroup> groups = equalFaces(byPosition.triangles, edges, progress.part(0.4, 0.5));
  if (groups.empty()) return 0;

  const std::map<Edge, Meeting> meetings = findMeetings(byPosition.triangles, groups, progress.part(0.5, 0.6));
  if (progress.cancelled()) return 0;
  DisjointSets sets(groups.size());
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    if (!pollProgress(g, groups.size(), progress.part(0.6, 0.65), kSearchesPerPoll)) return 0;
    for (int k = 0; k < 3; ++k) sets.join(g, meetings.at(edge(groups[g].positions, k)).firstGroup);
  }
  std::map<std::uint32_t, Choice> choices;
  for (const auto& [e, meeting] : meetings) choices[sets.root(meeting.firstGroup)].count(meeting);
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    if (!pollProgress(g, groups.size(), progress.part(0.65, 0.7), kSearchesPerPoll)) return 0;
    Choice& choice = choices[sets.root(g)];
    choice.platesOnly = choice.platesOnly && isPlate(groups[g], byPosition.triangles);
    ++choice.groups;
  }
  std::size_t removed = 0;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    const auto isMeant = [&](Face f) { return !only || only->contains(f); };
    if (std::none_of(groups[g].faces.begin(), groups[g].faces.end(), isMeant)) continue;
    const auto keep = static_cast<std::size_t>(choices[sets.root(g)].keep());
    for (std::size_t i = keep; i < groups[g].faces.size(); ++i, ++removed) mesh.removeFace(groups[g].faces[i]);
  }
  if (removed > 0) relink(mesh, progress.part(0.7, 1.0));
  return removed;
}

}  // namespace handwheel
