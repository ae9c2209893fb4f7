// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/DuplicateFaces.h"

#include "mesh/DisjointSets.h"
#include "mesh/EdgeTable.h"
#include "mesh/MeshBuilder.h"
#include "mesh/PositionTriangles.h"

#include <algorithm>
#include <map>

namespace handwheel {
namespace {

// Faces over the same three positions.
struct Group {
  Triangle positions;  // classes, ascending
  std::vector<Face> faces;
  bool isPlate = false;  // two faces, back to back
};

// Of two triangles over the same three positions: true when they look opposite ways.
bool areOpposite(const Triangle& a, const Triangle& b) {
  const auto at = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return b[static_cast<std::size_t>((at + 1) % 3)] == a[2];
}

std::vector<Group> findGroups(const std::vector<Triangle>& triangles) {
  std::map<Triangle, std::vector<Face>> byPositions;
  for (Face f = 0; f < triangles.size(); ++f) {
    Triangle t = triangles[f];
    if (hasRepeatedVertex(t)) continue;
    std::sort(t.begin(), t.end());
    byPositions[t].push_back(f);
  }
  std::vector<Group> groups;
  for (auto& [t, faces] : byPositions) {
    if (faces.size() < 2) continue;
    const bool isPlate = faces.size() == 2 && areOpposite(triangles[faces[0]], triangles[faces[1]]);
    groups.push_back({t, std::move(faces), isPlate});
  }
  return groups;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;
Edge edge(const Triangle& sorted, int k) {
  return std::minmax(sorted[k], sorted[(k + 1) % 3]);
}

// An edge of duplicates: how many groups meet there, and how many faces that have no duplicate.
struct Meeting {
  int groups = 0;
  int others = 0;
  std::uint32_t firstGroup = 0;
};

std::map<Edge, Meeting> findMeetings(const std::vector<Triangle>& triangles, const std::vector<Group>& groups) {
  std::map<Edge, Meeting> meetings;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    for (int k = 0; k < 3; ++k) {
      Meeting& m = meetings.try_emplace(edge(groups[g].positions, k), Meeting{0, 0, g}).first->second;
      ++m.groups;
      m.others -= static_cast<int>(groups[g].faces.size());  // its faces are counted below
    }
  }
  for (const Triangle& t : triangles) {
    if (hasRepeatedVertex(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const auto at = meetings.find(edge(t, k));
      if (at != meetings.end()) ++at->second.others;
    }
  }
  return meetings;
}

// For duplicates that hang together, the edges that would be open or crowded if none, one or two of each group stayed.
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

std::size_t removeDuplicateFaces(HalfEdgeMesh& mesh) {
  const PositionTriangles byPosition(mesh);
  const std::vector<Group> groups = findGroups(byPosition.triangles);
  if (groups.empty()) return 0;

  const std::map<Edge, Meeting> meetings = findMeetings(byPosition.triangles, groups);
  DisjointSets sets(groups.size());
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    for (int k = 0; k < 3; ++k) sets.join(g, meetings.at(edge(groups[g].positions, k)).firstGroup);
  }
  std::map<std::uint32_t, Choice> choices;
  for (const auto& [e, meeting] : meetings) choices[sets.root(meeting.firstGroup)].count(meeting);
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    Choice& choice = choices[sets.root(g)];
    choice.platesOnly = choice.platesOnly && groups[g].isPlate;
    ++choice.groups;
  }
  std::size_t removed = 0;
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    const auto keep = static_cast<std::size_t>(choices[sets.root(g)].keep());
    for (std::size_t i = keep; i < groups[g].faces.size(); ++i, ++removed) mesh.removeFace(groups[g].faces[i]);
  }
  if (removed > 0) relink(mesh);
  return removed;
}

}  // namespace handwheel
