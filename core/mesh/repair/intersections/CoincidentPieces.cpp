// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/CoincidentPieces.h"

#include "mesh/defects/DuplicateFaces.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/PositionTriangles.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

namespace handwheel {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // smaller class first

// Returns +1 if a triangle runs along its edge k from the smaller class to the larger, else -1.
int directionAt(const Triangle& t, int k) {
  return t[k] < t[(k + 1) % 3] ? 1 : -1;
}

Edge edgeAt(const Triangle& t, int k) {
  return std::minmax(t[k], t[(k + 1) % 3]);
}

// Equal pieces, by their orientation.
struct Pile {
  std::array<std::vector<Face>, 2> sides;
  bool isMixed() const { return !sides[0].empty() && !sides[1].empty(); }
};

// The numbers of pieces of each side of a pile that stay.
using KeptSides = std::array<int, 2>;

class Joiner {
 public:
  Joiner(const HalfEdgeMesh& mesh, Face firstPiece, Progress progress)
      : m_byPosition(mesh, progress.part(0.0, 0.4)), m_triangles(m_byPosition.triangles) {
    if (progress.cancelled()) return;
    const EdgeTable edges(m_triangles, m_byPosition.classes.representative.size(), progress.part(0.4, 0.7));
    for (const FaceGroup& group : equalFaces(m_triangles, edges, progress.part(0.7, 0.8))) {
      Pile pile;
      for (const Face f : group.faces)
        if (f >= firstPiece) pile.sides[looksUp(m_triangles[f])].push_back(f);
      if (pile.sides[0].size() + pile.sides[1].size() > 1) m_piles.push_back(std::move(pile));
    }
    if (!m_piles.empty()) connect(progress.part(0.8, 1.0));
  }

  std::vector<Face> toRemove() {
    std::map<std::uint32_t, std::vector<std::uint32_t>> sets;
    if (m_piles.empty()) return {};
    DisjointSets joined(m_piles.size());
    for (const auto& [e, at] : m_at)
      for (const bool mixed : {false, true}) joinAlike(joined, at.piles, mixed);
    for (std::uint32_t p = 0; p < m_piles.size(); ++p) sets[joined.root(p)].push_back(p);
    std::vector<Face> removed;
    for (const auto& [root, piles] : sets) decide(piles, removed);
    return removed;
  }

 private:
  struct At {
    int sum = 0;          // sum of the directions of all faces
    std::size_t all = 0;  // faces
    std::vector<std::uint32_t> piles;
  };

  const Triangle& first(const Pile& pile) const {
    return m_triangles[pile.sides[pile.sides[0].empty() ? 1 : 0].front()];
  }

  void connect(Progress progress) {
    for (std::uint32_t p = 0; p < m_piles.size(); ++p)
      for (int k = 0; k < 3; ++k) m_at[edgeAt(first(m_piles[p]), k)].piles.push_back(p);
    for (const Triangle& t : m_triangles) {
      if (hasRepeatedVertex(t)) continue;
      for (int k = 0; k < 3; ++k) {
        const auto at = m_at.find(edgeAt(t, k));
        if (at == m_at.end()) continue;
        at->second.sum += directionAt(t, k);
        ++at->second.all;
      }
    }
    progress.set(1.0);
  }

  void joinAlike(DisjointSets& joined, const std::vector<std::uint32_t>& piles, bool mixed) const {
    std::uint32_t last = kNone;
    for (const std::uint32_t p : piles) {
      if (m_piles[p].isMixed() != mixed) continue;
      if (last != kNone) joined.join(last, p);
      last = p;
    }
  }

  // Returns for each pile the side that continues the first side of the first pile: neighbours traverse their edge in
  // opposite directions.
  std::map<std::uint32_t, int> sidesAlike(const std::vector<std::uint32_t>& piles) const {
    std::map<std::uint32_t, int> side;
    for (const std::uint32_t p : piles) side[p] = -1;
    std::vector<std::uint32_t> left{piles.front()};
    side[piles.front()] = 0;
    while (!left.empty()) {
      const std::uint32_t p = left.back();
      left.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Edge e = edgeAt(first(m_piles[p]), k);
        for (const std::uint32_t q : m_at.at(e).piles) {
          const auto at = side.find(q);
          if (at == side.end() || at->second >= 0) continue;
          const bool isSame = direction(m_piles[p], side[p], e) != direction(m_piles[q], side[p], e);
          at->second = isSame ? side[p] : 1 - side[p];
          left.push_back(q);
        }
      }
    }
    return side;
  }

  // Returns the direction of a triangle of this side along an edge of the pile.
  int direction(const Pile& pile, int side, const Edge& e) const {
    const Triangle& t = first(pile);
    int k = 0;
    while (edgeAt(t, k) != e) ++k;
    return looksUp(t) == (side == 1) ? directionAt(t, k) : -directionAt(t, k);
  }

  // Returns a measure of the openness of the surface at the edges of these piles, if keptOf() of each pile stay.
  template <class KeptOf>
  int openness(const std::vector<std::uint32_t>& piles, KeptOf keptOf) const {
    std::map<Edge, int> sums;
    for (const std::uint32_t p : piles) {
      const Pile& pile = m_piles[p];
      const KeptSides kept = keptOf(p);
      for (int k = 0; k < 3; ++k) {
        const Edge e = edgeAt(first(pile), k);
        int& sum = sums.try_emplace(e, m_at.at(e).sum).first->second;
        for (const int s : {0, 1}) sum += (kept[s] - static_cast<int>(pile.sides[s].size())) * direction(pile, s, e);
      }
    }
    int open = 0;
    for (const auto& [e, sum] : sums) open += std::abs(sum);
    return open;
  }

  // Returns true if no other face is at any of their edges.
  bool standAlone(const std::vector<std::uint32_t>& piles) const {
    std::map<Edge, std::size_t> own;
    for (const std::uint32_t p : piles)
      for (int k = 0; k < 3; ++k)
        own[edgeAt(first(m_piles[p]), k)] += m_piles[p].sides[0].size() + m_piles[p].sides[1].size();
    return std::all_of(own.begin(), own.end(), [&](const auto& e) { return e.second == m_at.at(e.first).all; });
  }

  void decide(const std::vector<std::uint32_t>& piles, std::vector<Face>& removed) const {
    const auto all = [&](std::uint32_t p) { return sizesOf(m_piles[p]); };
    const auto cancelled = [&](std::uint32_t p) {
      const KeptSides n = all(p);
      return KeptSides{std::max(0, n[0] - n[1]), std::max(0, n[1] - n[0])};
    };
    if (!m_piles[piles.front()].isMixed()) {
      const auto one = [&](std::uint32_t p) { return KeptSides{std::min(1, all(p)[0]), std::min(1, all(p)[1])}; };
      if (openness(piles, one) <= openness(piles, all)) keep(piles, one, removed);
      return;
    }
    if (standAlone(piles)) return;
    if (openness(piles, cancelled) == 0) return keep(piles, cancelled, removed);
    const std::map<std::uint32_t, int> side = sidesAlike(piles);
    const auto oneOf = [&](int which) {
      return [&side, which](std::uint32_t p) { return side.at(p) == which ? KeptSides{1, 0} : KeptSides{0, 1}; };
    };
    keep(piles, oneOf(openness(piles, oneOf(0)) <= openness(piles, oneOf(1)) ? 0 : 1), removed);
  }

  static KeptSides sizesOf(const Pile& pile) {
    return {static_cast<int>(pile.sides[0].size()), static_cast<int>(pile.sides[1].size())};
  }

  template <class KeptOf>
  void keep(const std::vector<std::uint32_t>& piles, KeptOf keptOf, std::vector<Face>& removed) const {
    for (const std::uint32_t p : piles) {
      const KeptSides kept = keptOf(p);
      for (const int s : {0, 1}) {
        const std::vector<Face>& faces = m_piles[p].sides[s];
        removed.insert(removed.end(), faces.begin() + kept[s], faces.end());
      }
    }
  }

  const PositionTriangles m_byPosition;
  const std::vector<Triangle>& m_triangles;
  std::vector<Pile> m_piles;
  std::map<Edge, At> m_at;
};

}  // namespace

std::size_t joinCoincidentPieces(HalfEdgeMesh& mesh, Face firstPiece, Progress progress) {
  const std::vector<Face> removed = Joiner(mesh, firstPiece, progress).toRemove();
  if (progress.cancelled()) return 0;
  for (const Face f : removed) mesh.removeFace(f);
  return removed.size();
}

}  // namespace handwheel
