// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/HoleDecomposition.h"

#include "mesh/holes/HoleBridgeSearch.h"

#include <algorithm>

namespace handwheel {

std::vector<HoleBridge> proposeHoleBridges(const HoleContext& hole, const Obstacles& obstacles, std::size_t pieceEdges,
                                           Progress progress) {
  std::vector<HoleBridge> bridges;
  const std::size_t limit = std::max<std::size_t>(pieceEdges, 4);
  if (hole.loopSize <= limit) return bridges;
  HolePiece whole(hole.loopSize);
  for (std::uint32_t i = 0; i < hole.loopSize; ++i) whole[i] = i;
  const HoleBridgeSearch search(hole, obstacles);
  std::vector<HolePiece> open{std::move(whole)};
  std::size_t settled = 0;  // points of pieces that are short enough
  while (!open.empty() && !progress.cancelled()) {
    const HolePiece piece = std::move(open.back());
    open.pop_back();
    const std::optional<HoleBridge> cut = piece.size() > limit ? search.best(piece, progress) : std::nullopt;
    if (!cut) {
      settled += piece.size();
      progress.set(std::min(1.0, static_cast<double>(settled) / static_cast<double>(hole.loopSize)));
      continue;
    }
    bridges.push_back({piece[cut->a], piece[cut->b]});
    const auto a = piece.begin() + cut->a, b = piece.begin() + cut->b;
    open.emplace_back(a, b + 1);
    HolePiece rest(piece.begin(), a + 1);
    rest.insert(rest.end(), b, piece.end());
    open.push_back(std::move(rest));
  }
  return bridges;
}

std::optional<std::vector<HolePiece>> splitHole(std::size_t loopSize, const std::vector<HoleBridge>& bridges) {
  std::vector<HolePiece> pieces(1);
  for (std::uint32_t i = 0; i < loopSize; ++i) pieces[0].push_back(i);
  for (const HoleBridge& s : bridges) {
    const auto [low, high] = std::minmax(s.a, s.b);
    bool isCut = false;
    for (std::size_t i = 0; i < pieces.size() && !isCut; ++i) {
      const HolePiece& piece = pieces[i];  // its numbers rise
      if (low < piece.front() || high > piece.back()) continue;
      const auto a = std::lower_bound(piece.begin(), piece.end(), low);
      const auto b = std::lower_bound(piece.begin(), piece.end(), high);
      if (a == piece.end() || *a != low || b == piece.end() || *b != high) continue;
      const auto inside = b - a;
      if (inside < 2 || inside > static_cast<std::ptrdiff_t>(piece.size()) - 2) continue;
      HolePiece inner(a, b + 1), rest(piece.begin(), a + 1);
      rest.insert(rest.end(), b, piece.end());
      pieces[i] = std::move(rest);
      pieces.push_back(std::move(inner));
      isCut = true;
    }
    if (!isCut) return std::nullopt;
  }
  return pieces;
}

HoleContext contextOf(const HoleContext& hole, const HolePiece& piece) {
  HoleContext context;
  const std::size_t n = piece.size();
  context.loopSize = n;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t from = piece[i], to = piece[(i + 1) % n];
    const auto steps = static_cast<std::uint32_t>((to + hole.loopSize - from) % hole.loopSize);
    context.points.push_back(hole.points[from]);
    context.edgeLength.push_back(hole.edgeLength[from]);
    context.ringBox.extend(hole.points[from]);
    context.apexes.push_back(steps == 1 ? hole.apexes[from] : hole.points[(from + steps / 2) % hole.loopSize]);
  }
  return context;
}

Patch joined(const HoleContext& hole, const std::vector<HolePiece>& pieces, const std::vector<Patch>& patches) {
  Patch whole;
  whole.loopSize = hole.loopSize;
  whole.points = hole.loop();
  whole.method = patches.front().method;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const Triangle& t : patches[i].triangles) {
      whole.triangles.push_back({pieces[i][t[0]], pieces[i][t[1]], pieces[i][t[2]]});
    }
  }
  return whole;
}

}  // namespace handwheel
