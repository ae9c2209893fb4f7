// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/SolidSubtraction.h"

#include "base/Tolerance.h"
#include "mesh/repair/intersections/Autorefinement.h"
#include "mesh/structure/DisjointSets.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/SolidAngle.h"
#include "mesh/structure/Weld.h"
#include "proximity/SelfIntersection.h"
#include "proximity/TriangleIntersection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace handwheel {
namespace {

// A large face of a plate has the whole rim of a fine hole in it.
constexpr std::size_t kCutsPerPartFace = 10'000;
// Largest number of solid angles to add, some ten seconds.
constexpr double kMostAngles = 5e8;

// Returns the solid as a file of this number type stores it, without triangles that collapse to edges or points.
TriangleSoup storedSolid(const TriangleSoup& soup, NumberType numbers) {
  TriangleSoup stored = soup;
  roundPoints(stored, numbers);
  stored = weld(stored);
  std::erase_if(stored.triangles, [](const Triangle& t) { return hasRepeatedVertex(t); });
  return stored;
}

bool isWithoutBorder(const HalfEdgeMesh& mesh) {
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (!mesh.hasOpposite(h)) return false;
  return true;
}

// Returns true if every edge has two consistently oriented faces, and every vertex one fan.
bool isClosedManifold(const BuiltMesh& built) {
  const BuildReport& report = built.report;
  return report.reversedFaces.empty() && report.splitVertices.empty() && report.nonManifoldEdges == 0 &&
         report.unpairedHalfEdges == 0 && validate(built.mesh).empty() && isWithoutBorder(built.mesh);
}

TrianglePoints cornersOf(const TriangleSoup& soup, const Triangle& t) {
  return {soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
}

// A closed surface with its winding numbers.
class SolidSide {
 public:
  explicit SolidSide(const TriangleSoup& soup) : m_soup(soup) {
    for (const Vec3& p : soup.points) m_box.extend(p);
  }

  std::size_t size() const { return m_soup.triangles.size(); }
  // Returns the winding number around a position; nothing if it is no integer, as on the surface.
  std::optional<int> windingAt(const Vec3& position) const {
    if (!m_box.contains(position)) return 0;
    double angle = 0.0;
    for (const Triangle& t : m_soup.triangles) angle += solidAngle(cornersOf(m_soup, t), position);
    const double number = angle / (4.0 * std::numbers::pi), whole = std::round(number);
    if (!(std::abs(number - whole) <= tolerance::kWindingDoubt)) return std::nullopt;
    return static_cast<int>(whole);
  }

 private:
  const TriangleSoup& m_soup;
  Box m_box;
};

// The triangles of both solids once they are cut along each other: first those of the part.
struct CutSolids {
  TriangleSoup soup;
  std::vector<bool> isTool, isPiece;  // by triangle

  void add(const Triangle& t, bool ofTool, bool asPiece) {
    soup.triangles.push_back(t);
    isTool.push_back(ofTool);
    isPiece.push_back(asPiece);
  }
};

CutSolids cutSolids(const TriangleSoup& both, std::size_t partCount, const Autorefinement& cuts) {
  CutSolids cut;
  cut.soup.points = cuts.points;
  for (std::size_t t = 0; t < both.triangles.size(); ++t) {
    const auto at = cuts.piecesOf.find(static_cast<std::uint32_t>(t));
    if (at == cuts.piecesOf.end()) {
      cut.add(both.triangles[t], t >= partCount, false);
      continue;
    }
    for (const Triangle& piece : at->second) cut.add(piece, t >= partCount, true);
  }
  return cut;
}

// Finds the sets of triangles that are connected without crossing an edge of both surfaces.
DisjointSets sheetsBetweenCuts(const CutSolids& cut, Progress progress) {
  DisjointSets sheets(cut.soup.triangles.size());
  const EdgeTable edges(cut.soup.triangles, cut.soup.points.size(), progress.part(0.0, 0.5));
  edges.forEachEdge(
      [&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> entries) {
        const std::uint32_t first = entries.front().halfEdge / 3;
        const auto isOfFirst = [&](const EdgeTable::Entry& e) {
          return cut.isTool[e.halfEdge / 3] == cut.isTool[first];
        };
        if (!std::all_of(entries.begin(), entries.end(), isOfFirst)) return;
        for (const EdgeTable::Entry& e : entries) sheets.join(first, e.halfEdge / 3);
      },
      progress.part(0.5, 1.0));
  return sheets;
}

// Returns the triangles that stay; nothing if that is uncertain.
std::optional<std::vector<bool>> stayingTriangles(const CutSolids& cut, const SolidSide& part, const SolidSide& tool,
                                                  SubtractionProblem& problem, Progress progress) {
  DisjointSets sheets = sheetsBetweenCuts(cut, progress.part(0.0, 0.3));
  std::map<std::uint32_t, std::uint32_t> largest;  // triangle of a sheet, by its root
  const auto area = [&](std::uint32_t t) { return areaOf(cornersOf(cut.soup, cut.soup.triangles[t])); };
  double angles = 0.0;
  for (std::uint32_t t = 0; t < cut.soup.triangles.size(); ++t) {
    const auto [at, isNew] = largest.try_emplace(sheets.root(t), t);
    if (isNew) angles += static_cast<double>((cut.isTool[t] ? part : tool).size());
    if (area(t) > area(at->second)) at->second = t;
  }
  problem = SubtractionProblem::TooManyIntersections;
  if (angles > kMostAngles) return std::nullopt;
  problem = SubtractionProblem::Unsound;
  std::map<std::uint32_t, bool> stays;  // by root
  for (const auto& [root, t] : largest) {
    if (progress.cancelled()) return std::nullopt;
    progress.set(0.3 + 0.7 * static_cast<double>(stays.size()) / static_cast<double>(largest.size()));
    const TrianglePoints p = cornersOf(cut.soup, cut.soup.triangles[t]);
    const bool isOfTool = cut.isTool[t];
    const std::optional<int> winding = (isOfTool ? part : tool).windingAt((p[0] + p[1] + p[2]) / 3.0);
    if (!winding || *winding < 0 || *winding > 1) return std::nullopt;
    stays[root] = (*winding == 1) == isOfTool;
  }
  std::vector<bool> staying(cut.soup.triangles.size());
  for (std::uint32_t t = 0; t < staying.size(); ++t) staying[t] = stays.at(sheets.root(t));
  problem = SubtractionProblem::None;
  return staying;
}

// The unchanged triangles of the part come first, then the pieces and those of the tool.
Subtraction joined(const CutSolids& cut, const std::vector<bool>& staying, Progress progress) {
  Subtraction done;
  TriangleSoup soup{cut.soup.points, {}};
  const auto isKept = [&](std::size_t t) { return !cut.isTool[t] && !cut.isPiece[t]; };
  for (std::size_t t = 0; t < staying.size(); ++t)
    if (staying[t] && isKept(t)) soup.triangles.push_back(cut.soup.triangles[t]);
  done.kept = soup.triangles.size();
  for (std::size_t t = 0; t < staying.size(); ++t) {
    if (!staying[t] || isKept(t)) continue;
    Triangle corners = cut.soup.triangles[t];
    if (cut.isTool[t]) std::swap(corners[1], corners[2]);
    soup.triangles.push_back(corners);
  }
  if (soup.triangles.empty()) return done;
  soup = weld(soup);
  for (std::size_t t = done.kept; t < soup.triangles.size(); ++t)
    if (isDegenerate(cornersOf(soup, soup.triangles[t]))) return {{}, SubtractionProblem::Unsound, 0};
  BuiltMesh built = buildMesh(soup, progress.part(0.0, 0.4));
  const auto pairs = selfIntersections(soup.points, soup.triangles, progress.part(0.4, 1.0), 1);
  if (!pairs || !pairs->empty() || !isClosedManifold(built)) return {{}, SubtractionProblem::Unsound, 0};
  done.mesh = std::move(built.mesh);
  return done;
}

}  // namespace

Subtraction subtractSolid(const TriangleSoup& part, const TriangleSoup& tool, NumberType numbers, Progress progress) {
  const auto refused = [](SubtractionProblem problem) { return Subtraction{{}, problem, 0}; };
  TriangleSoup both = storedSolid(part, numbers);
  const std::size_t partCount = both.triangles.size();
  const TriangleSoup first = both, second = storedSolid(tool, numbers);
  if (!isClosedManifold(buildMesh(first, progress.part(0.0, 0.1)))) return refused(SubtractionProblem::NotClosed);
  if (!isClosedManifold(buildMesh(second, progress.part(0.1, 0.15)))) return refused(SubtractionProblem::Unsound);
  const auto shift = static_cast<std::uint32_t>(both.points.size());
  both.points.insert(both.points.end(), second.points.begin(), second.points.end());
  for (const Triangle& t : second.triangles) both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  both = weld(both);

  const auto pairs = selfIntersections(both.points, both.triangles, progress.part(0.15, 0.3),
                                       tolerance::kMaxSelfIntersectionPairs + 1);
  if (!pairs) return refused(SubtractionProblem::Unsound);
  const auto isWithinPart = [&](const TrianglePair& pair) { return pair.second < partCount; };
  const auto isWithinTool = [&](const TrianglePair& pair) { return pair.first >= partCount; };
  if (std::any_of(pairs->begin(), pairs->end(), isWithinPart)) return refused(SubtractionProblem::IntersectsItself);
  if (pairs->size() > tolerance::kMaxSelfIntersectionPairs) return refused(SubtractionProblem::TooManyIntersections);
  if (std::any_of(pairs->begin(), pairs->end(), isWithinTool)) return refused(SubtractionProblem::Unsound);
  const Autorefinement cuts =
      autorefine(both, *pairs, numbers, progress.part(0.3, 0.6), SharedPlanes(), kCutsPerPartFace);
  if (!pairs->empty() && cuts.piecesOf.empty()) return refused(SubtractionProblem::TooManyIntersections);
  const CutSolids cut = cutSolids(both, partCount, cuts);
  SubtractionProblem problem = SubtractionProblem::None;
  const auto staying = stayingTriangles(cut, SolidSide(first), SolidSide(second), problem, progress.part(0.6, 0.8));
  if (!staying) return refused(problem);
  return joined(cut, *staying, progress.part(0.8, 1.0));
}

}  // namespace handwheel
