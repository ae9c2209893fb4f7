// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/TransformTool.h"

#include "base/Units.h"
#include "document/mesh/MeshDocument.h"
#include "mesh/Transforming.h"
#include "tools/ToolProperty.h"

#include <QtGlobal>
#include <algorithm>
#include <numbers>
#include <optional>

namespace handwheel {
namespace {

constexpr Limits kShift = {-1e9, 1e9};  // mm
constexpr Limits kTurn = {-2.0 * std::numbers::pi, 2.0 * std::numbers::pi};
constexpr Limits kScale = {1e-9, 1e9};
constexpr LengthUnit kUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch};
constexpr const char* kShiftIds[] = {"shift_x", "shift_y", "shift_z"};
constexpr const char* kTurnIds[] = {"turn_x", "turn_y", "turn_z"};
constexpr const char* kShiftLabels[] = {QT_TRANSLATE_NOOP("Property", "Move along X"),
                                        QT_TRANSLATE_NOOP("Property", "Move along Y"),
                                        QT_TRANSLATE_NOOP("Property", "Move along Z")};
constexpr const char* kTurnLabels[] = {QT_TRANSLATE_NOOP("Property", "Turn about X"),
                                       QT_TRANSLATE_NOOP("Property", "Turn about Y"),
                                       QT_TRANSLATE_NOOP("Property", "Turn about Z")};

// What cannot be placed stays as it is, and the change says why.
void place(HalfEdgeMesh& mesh, const Eigen::Affine3d& by) {
  [[maybe_unused]] const Status placed = transform(mesh, by);
}

// A placement that depends on the mesh as it is when the change is made.
using Finder = std::optional<Pose> (*)(const HalfEdgeMesh&, Progress);
struct Standard {
  const char* id;
  const char* effect;
  const char* text;
  const char* hindrance;
  Finder find;
};
constexpr const char* kNoArea = QT_TRANSLATE_NOOP("Tool", "it is there already, has no area, or is too large to tell");
constexpr Standard kStandards[] = {
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

}  // namespace

Eigen::Affine3d TransformTool::placement() const {
  const Box& box = m_document.defects().box;
  const double unit = unitScale(kUnits[m_unit], LengthUnit::Millimetre);
  const Vec3 centre = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(unit * box.center());
  const Vec3 shift(m_shift[0], m_shift[1], m_shift[2]);
  return Eigen::Translation3d(centre + shift) * Eigen::AngleAxisd(m_turn[2], Vec3::UnitZ()) *
         Eigen::AngleAxisd(m_turn[1], Vec3::UnitY()) * Eigen::AngleAxisd(m_turn[0], Vec3::UnitX()) *
         Eigen::Scaling(m_scale) * Eigen::Translation3d(-centre) * Eigen::Scaling(unit);
}

bool TransformTool::isIdle() const {
  const auto isZero = [](double value) { return value == 0.0; };
  return std::all_of(m_shift.begin(), m_shift.end(), isZero) && std::all_of(m_turn.begin(), m_turn.end(), isZero) &&
         m_scale == 1.0 && m_unit == 0;
}

void TransformTool::reset() {
  m_shift = m_turn = {};
  m_scale = 1.0;
  m_unit = 0;
}

ToolReply TransformTool::perform(std::string_view action) {
  if (action == "revert") {
    if (isIdle()) return ToolReply::Finished;
    reset();
    return ToolReply::Used;
  }
  if (action == "commit") {
    m_services.commit({QT_TRANSLATE_NOOP("Tool", "Place"),
                       [by = placement()](HalfEdgeMesh& mesh, Progress) { place(mesh, by); },
                       QT_TRANSLATE_NOOP("Tool", "coordinates would become too large")});
    reset();
    return ToolReply::Used;
  }
  for (const Standard& standard : kStandards) {
    if (action != standard.id) continue;
    m_services.commit({standard.text,
                       [find = standard.find](HalfEdgeMesh& mesh, Progress progress) {
                         if (const auto pose = find(mesh, progress)) place(mesh, *pose);
                       },
                       standard.hindrance});
    return ToolReply::Used;
  }
  return ToolReply::Ignored;
}

std::span<const ToolKey> TransformTool::keys() {
  static const std::vector<ToolKey> all = [] {
    std::vector<ToolKey> keys = {{"commit", "Return", QT_TRANSLATE_NOOP("Tool", "place so")}};
    for (const Standard& standard : kStandards) keys.push_back({standard.id, "", standard.effect});
    keys.push_back({"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "reset")});
    return keys;
  }();
  return all;
}

std::vector<ToolAction> TransformTool::actions() const {
  std::vector<ToolAction> all = {actionOf(keys(), "commit", !isIdle())};
  for (const Standard& standard : kStandards) all.push_back(actionOf(keys(), standard.id));
  all.push_back(actionOf(keys(), "revert", true, isIdle() ? QT_TRANSLATE_NOOP("Tool", "done") : nullptr));
  return all;
}

ToolPreview TransformTool::preview() const {
  ToolPreview preview;
  const Box& box = m_document.defects().box;
  if (box.isEmpty() || isIdle()) return preview;
  const Eigen::Affine3d by = placement();
  const auto corner = [&](int i) -> Vec3 { return by * box.corner(static_cast<Box::CornerType>(i)); };
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 8; ++i) {
      if ((i >> axis & 1) == 0) preview.lines.push_back({corner(i), corner(i | 1 << axis)});
    }
  }
  return preview;
}

std::vector<Property> TransformTool::settings() const {
  std::vector<Property> all;
  for (std::size_t i = 0; i < 3; ++i)
    all.push_back(numberSetting(kShiftIds[i], kShiftLabels[i], m_shift[i], Quantity::Length, kShift));
  for (std::size_t i = 0; i < 3; ++i)
    all.push_back(numberSetting(kTurnIds[i], kTurnLabels[i], m_turn[i], Quantity::Angle, kTurn));
  all.push_back(numberSetting("scale", QT_TRANSLATE_NOOP("Property", "Scale by"), m_scale, Quantity::Number, kScale));
  std::vector<std::string> units;
  for (const LengthUnit unit : kUnits) units.emplace_back(symbolOf(unit));
  all.push_back(choiceSetting("unit", QT_TRANSLATE_NOOP("Property", "The file is in"), m_unit, std::move(units)));
  return all;
}

void TransformTool::setSetting(std::string_view id, const PropertyValue& value) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (id == kShiftIds[i]) takeNumber(m_shift[i], value, kShift);
    if (id == kTurnIds[i]) takeNumber(m_turn[i], value, kTurn);
  }
  if (id == "scale") takeNumber(m_scale, value, kScale);
  if (id == "unit") takeChoice(m_unit, value, static_cast<int>(std::size(kUnits)));
}

}  // namespace handwheel
