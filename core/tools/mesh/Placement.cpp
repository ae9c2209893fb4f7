// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/Placement.h"

#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/Transforming.h"
#include "tools/mesh/ScriptLine.h"
#include "tools/mesh/operations/MeshOperations.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {
namespace {

constexpr const char* kTooLarge = QT_TRANSLATE_NOOP("Tool", "coordinates would become too large");
constexpr const char* kInPlace = QT_TRANSLATE_NOOP("Tool", "it is already in place");
constexpr const char* kNoArea = QT_TRANSLATE_NOOP("Tool", "it has no area");

// Places the mesh, or leaves it unchanged if that is impossible. Returns the reason if nothing changed.
const char* place(HalfEdgeMesh& mesh, const Eigen::Affine3d& by) {
  return transform(mesh, by) ? kInPlace : kTooLarge;
}

constexpr StandardPlacement kStandards[] = {
    {"flat", QT_TRANSLATE_NOOP("Tool", "place on the largest flat face"),
     QT_TRANSLATE_NOOP("Tool", "Place on the largest flat face"),
     QT_TRANSLATE_NOOP("Tool", "there is no flat face that the part can stand on"),
     [](const HalfEdgeMesh& mesh, Progress p) { return ontoLargestFlatFace(mesh, {}, p); }},
    {"axes", QT_TRANSLATE_NOOP("Tool", "align the principal axes"),
     QT_TRANSLATE_NOOP("Tool", "Align the principal axes"), kNoArea,
     [](const HalfEdgeMesh& mesh, Progress) { return ontoPrincipalAxes(mesh); }},
    {"centre", QT_TRANSLATE_NOOP("Tool", "centre on the origin"), QT_TRANSLATE_NOOP("Tool", "Centre on the origin"),
     kNoArea, [](const HalfEdgeMesh& mesh, Progress) { return boxToOrigin(mesh, Vec3::Constant(0.5)); }},
    {"corner", QT_TRANSLATE_NOOP("Tool", "move the minimum corner to the origin"),
     QT_TRANSLATE_NOOP("Tool", "Move the minimum corner to the origin"), kNoArea,
     [](const HalfEdgeMesh& mesh, Progress) { return boxToOrigin(mesh, Vec3::Zero()); }}};

}  // namespace

Eigen::Affine3d Placement::of(const Box& box) const {
  const double toMillimetres = kUnits[unit].millimetres;
  const Vec3 centre = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(toMillimetres * box.center());
  return Eigen::Translation3d(centre + Vec3(shift[0], shift[1], shift[2])) * Eigen::AngleAxisd(turn[2], Vec3::UnitZ()) *
         Eigen::AngleAxisd(turn[1], Vec3::UnitY()) * Eigen::AngleAxisd(turn[0], Vec3::UnitX()) * Eigen::Scaling(scale) *
         Eigen::Translation3d(-centre) * Eigen::Scaling(toMillimetres);
}

Placement placementOf(const OperationValues& values) {
  Placement placement;
  placement.unit = values.whole("unit");
  placement.scale = values.number("scale");
  const std::vector<double> turn = values.numbers("turn"), shift = values.numbers("move");
  std::copy(turn.begin(), turn.end(), placement.turn.begin());
  std::copy(shift.begin(), shift.end(), placement.shift.begin());
  return placement;
}

OperationValues valuesOf(const Placement& placement) {
  OperationValues values(meshOperation("place"));
  values.setValid("unit", static_cast<double>(placement.unit));
  values.setValid("scale", placement.scale);
  values.setValid("turn", std::vector<double>(placement.turn.begin(), placement.turn.end()));
  values.setValid("move", std::vector<double>(placement.shift.begin(), placement.shift.end()));
  return values;
}

MeshChange placementChange(const Placement& placement) {
  return withStep({meshOperation("place").title,
                   [placement](HalfEdgeMesh& mesh, Progress) { place(mesh, placement.of(boundsOf(mesh))); }, kTooLarge},
                  ScriptLineWriter("place").options(valuesOf(placement)).text());
}

std::span<const StandardPlacement> standardPlacements() {
  return kStandards;
}

MeshChange placementChange(const StandardPlacement& standard) {
  return withStep(explainedChange(standard.text,
                                  [find = standard.find, reason = standard.reason](HalfEdgeMesh& mesh, Progress p) {
                                    const auto pose = find(mesh, p);
                                    return pose ? place(mesh, *pose) : reason;
                                  }),
                  standard.id);
}

}  // namespace handwheel
