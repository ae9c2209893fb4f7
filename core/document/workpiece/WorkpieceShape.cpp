// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceShape.h"

#include "base/Tolerance.h"
#include "document/DocumentErrors.h"
#include "document/workpiece/WorkpieceErrors.h"
#include "machining/section/SectionOutline.h"
#include "nurbs/StepWriter.h"
#include "nurbs/Tessellation.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace handwheel {

namespace {

Error notAsMeant(const char* what) {
  return {DocumentError::CheckFailed, {what}, {}, {}};
}

void append(TriangleSoup& all, const TriangleSoup& soup, bool isTurned) {
  const auto base = static_cast<std::uint32_t>(all.points.size());
  all.points.insert(all.points.end(), soup.points.begin(), soup.points.end());
  for (Triangle t : soup.triangles) {
    if (isTurned) std::swap(t[1], t[2]);
    all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
}

// The blocks that show the part: a thread is no surface of revolution.
TriangleSoup threadedTriangles(const WorkpieceSnapshot& workpiece) {
  TriangleSoup all;
  for (const auto& block : workpiece.part->surface.blocks()) append(all, *block, false);
  for (Vec3& p : all.points) p.z() += workpiece.stock.position;
  return all;
}

Result<std::vector<TurnedCurves>> curvesWithin(const WorkpieceSnapshot& workpiece, double chord) {
  std::vector<TurnedCurves> all;
  if (!workpiece.part) {
    all.push_back({workpiece.stock.profile(), {}});
    return all;
  }
  for (const TurnedSection& piece : workpiece.part->section().pieces()) {
    Result<TurnedCurves> curves = curvesOf(piece, chord, workpiece.stock.position);
    if (!curves) return curves.error();
    all.push_back(std::move(curves).value());
  }
  if (all.empty()) return Error{ErrorCode::ElementMalformed, {"profile", "nothing is left of the part"}, {}, {}};
  return all;
}

// Returns the curve of the piece at the free end. If none is good enough, the best one is returned: the library is slow
// on solids with many faces.
Result<ProfileCurve> solidCurve(const WorkpieceSnapshot& workpiece) {
  constexpr double kVolume = 5e-5;
  constexpr std::size_t kManyArcs = 5'000;
  const auto parts = workpiece.part ? workpiece.part->section().pieces() : std::vector<TurnedSection>();
  const double volume = parts.empty() ? workpiece.stock.volume() : parts.back().volume();
  std::optional<ProfileCurve> best;
  double least = std::numeric_limits<double>::infinity();
  for (double chord = 0.5 * workpiece.chord; !(least <= kVolume); chord *= 0.25) {
    const Result<std::vector<TurnedCurves>> pieces = curvesWithin(workpiece, chord);
    if (!pieces && best) break;
    if (!pieces) return pieces.error();
    const TurnedCurves& curves = pieces->back();
    if (!curves.cavities.empty())
      return Error{WorkpieceError::ClosedHollow, {std::to_string(curves.cavities.size())}, {}, {}};
    const double off = std::abs(curves.outside.volume() / volume - 1.0);
    if (best && (!(off < 0.9 * least) || curves.outside.arcs().size() > kManyArcs)) break;
    least = off;
    best = curves.outside;
  }
  return *best;
}

}  // namespace

Result<std::vector<TurnedCurves>> curvesOf(const WorkpieceSnapshot& workpiece) {
  return curvesWithin(workpiece, 0.5 * workpiece.chord);
}

Result<TriangleSoup> placedTriangles(const WorkpieceSnapshot& workpiece, Progress progress) {
  if (!workpiece.part) {
    TriangleSoup soup = *workpiece.mesh->soup();
    for (Vec3& p : soup.points) p.z() += workpiece.stock.position;
    return soup;
  }
  if (workpiece.part->threads()) return threadedTriangles(workpiece);
  const Result<std::vector<TurnedCurves>> pieces = curvesOf(workpiece);
  if (!pieces) return pieces.error();
  TessellationOptions options;
  options.chord = 0.5 * workpiece.chord;
  TriangleSoup all;
  for (std::size_t i = 0; i < pieces->size(); ++i) {
    const auto part = progress.part(static_cast<double>(i) / static_cast<double>(pieces->size()),
                                    static_cast<double>(i + 1) / static_cast<double>(pieces->size()));
    const TurnedCurves& curves = (*pieces)[i];
    const Result<TriangleSoup> outside = tessellate(curves.outside, options, part);
    if (!outside) return outside.error();
    append(all, *outside, false);
    for (const ProfileCurve& cavity : curves.cavities) {
      const Result<TriangleSoup> hollow = tessellate(cavity, options, part);
      if (!hollow) return hollow.error();
      append(all, *hollow, true);
    }
  }
  return all;
}

Result<std::string> checkedStep(const WorkpieceSnapshot& workpiece, Progress progress) {
  const Result<ProfileCurve> curve = solidCurve(workpiece);
  if (!curve) return curve.error();
  Result<std::string> bytes = writeStep(*curve, progress.part(0.0, 0.5));
  if (!bytes) return bytes;
  const Result<StepFileReport> back = inspectStep(*bytes, progress.part(0.5, 1.0));
  if (!back && back.error().code != ErrorCode::LibraryFailed) return back.error();
  if (!back) return notAsMeant("it cannot be opened");
  if (back->solids != 1 || !back->isValid) return notAsMeant("it contains no valid solid");
  if (!(std::abs(back->volume / curve->volume() - 1.0) < tolerance::kWrittenVolume))
    return notAsMeant("its volume differs");
  return bytes;
}

}  // namespace handwheel
