// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/Placement.h"

#include "base/NumberText.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/Transforming.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {
namespace {

// What cannot be placed stays as it is, and the change says why.
void place(HalfEdgeMesh& mesh, const Eigen::Affine3d& by) {
  [[maybe_unused]] const Status placed = transform(mesh, by);
}

constexpr const char* kNoArea = QT_TRANSLATE_NOOP("Tool", "it is there already, has no area, or is too large to tell");
constexpr StandardPlace kStandards[] = {
    {"flat", QT_TRANSLATE_NOOP("Tool", "put onto the largest flat face"),
     QT_TRANSLATE_NOOP("Tool", "Put onto the largest flat face"),
     QT_TRANSLATE_NOOP("Tool", "there is no flat face that the part can stand on, or it stands on it already"),
     [](const HalfEdgeMesh& mesh, Progress p) { return ontoLargestFlatFace(mesh, {}, p); }},
    {"axes", QT_TRANSLATE_NOOP("Tool", "align the main axes"), QT_TRANSLATE_NOOP("Tool", "Align the main axes"),
     kNoArea, [](const HalfEdgeMesh& mesh, Progress) { return ontoPrincipalAxes(mesh); }},
    {"centre", QT_TRANSLATE_NOOP("Tool", "centre on the origin"), QT_TRANSLATE_NOOP("Tool", "Centre on the origin"),
     kNoArea, [](const HalfEdgeMesh& mesh, Progress) { return boxToOrigin(mesh, Vec3::Constant(0.5)); }},
    {"corner", QT_TRANSLATE_NOOP("Tool", "put the low corner into the origin"),
     QT_TRANSLATE_NOOP("Tool", "Put the low corner into the origin"), kNoArea,
     [](const HalfEdgeMesh& mesh, Progress) { return boxToOrigin(mesh, Vec3::Zero()); }}};

std::string stepOf(const Placement& placement) {
  const Placement none;
  StepWriter step("place");
  if (placement.unit != none.unit) step.option("unit", symbolOf(placement.unit));
  if (placement.scale != none.scale) step.option("scale", shortestText(placement.scale));
  const auto& turn = placement.turn;
  if (turn != none.turn) step.option("turn", angleText(turn[0]) + "," + angleText(turn[1]) + "," + angleText(turn[2]));
  const auto& shift = placement.shift;
  if (shift != none.shift) step.option("move", pointText({shift[0], shift[1], shift[2]}));
  return step.text();
}

}  // namespace

Eigen::Affine3d Placement::of(const Box& box) const {
  const double toMillimetres = unitScale(unit, LengthUnit::Millimetre);
  const Vec3 centre = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(toMillimetres * box.center());
  return Eigen::Translation3d(centre + Vec3(shift[0], shift[1], shift[2])) * Eigen::AngleAxisd(turn[2], Vec3::UnitZ()) *
         Eigen::AngleAxisd(turn[1], Vec3::UnitY()) * Eigen::AngleAxisd(turn[0], Vec3::UnitX()) * Eigen::Scaling(scale) *
         Eigen::Translation3d(-centre) * Eigen::Scaling(toMillimetres);
}

MeshChange placeChange(const Placement& placement) {
  return withStep({QT_TRANSLATE_NOOP("Tool", "Place"),
                   [placement](HalfEdgeMesh& mesh, Progress) { place(mesh, placement.of(boundsOf(mesh))); },
                   QT_TRANSLATE_NOOP("Tool", "coordinates would become too large")},
                  stepOf(placement));
}

Placement readPlacement(StepReader& reader) {
  Placement placement;
  if (const auto word = reader.option("unit"); word) {
    const auto* unit = std::find_if(std::begin(Placement::kUnits), std::end(Placement::kUnits),
                                    [&](LengthUnit u) { return symbolOf(u) == *word; });
    if (unit == std::end(Placement::kUnits)) {
      reader.complain("--unit takes mm, cm, m or in");
    } else {
      placement.unit = *unit;
    }
  }
  placement.scale = reader.number("scale", 1.0, Placement::kScale);
  if (const auto word = reader.option("turn"); word) {
    const std::vector<std::string_view> parts = parted(*word, ',');
    if (parts.size() != 3) reader.complain("--turn takes three angles: A,B,C");
    for (std::size_t i = 0; i < 3 && reader.isGood(); ++i) placement.turn[i] = reader.angle(parts[i], Placement::kTurn);
  }
  if (const auto word = reader.option("move"); word) {
    const Vec3 shift = reader.point(*word, Placement::kShift);
    placement.shift = {shift.x(), shift.y(), shift.z()};
  }
  return placement;
}

std::span<const StandardPlace> standardPlaces() {
  return kStandards;
}

MeshChange placeChange(const StandardPlace& standard) {
  return withStep({standard.text,
                   [find = standard.find](HalfEdgeMesh& mesh, Progress progress) {
                     if (const auto pose = find(mesh, progress)) place(mesh, *pose);
                   },
                   standard.reason},
                  standard.id);
}

}  // namespace handwheel
