// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/MeasureTool.h"

#include "mesh/structure/AngleBetween.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kArcPixels = 48.0;     // radius of the arc that marks an angle
constexpr double kNormalPixels = 64.0;  // length of the lines that stand on faces
constexpr int kRoundSteps = 24;         // for an arc or a circle
constexpr ToolKey kMeasureKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "start again")},
};

Property figure(const char* id, const char* label, double value, Quantity quantity) {
  Property property;
  property.id = id;
  property.label = label;
  property.value = value;
  property.quantity = quantity;
  property.editable = false;
  return property;
}

// Returns the great circle of a ball in the plane of two directions, from the first over so many radians.
std::vector<Vec3> arc(const Vec3& centre, const Vec3& from, const Vec3& towards, double radius, double angle) {
  const Vec3 u = from.stableNormalized();
  const Vec3 v = (towards - towards.dot(u) * u).stableNormalized();
  std::vector<Vec3> points;
  for (int i = 0; i <= kRoundSteps; ++i) {
    const double t = angle * i / kRoundSteps;
    points.push_back(centre + radius * (std::cos(t) * u + std::sin(t) * v));
  }
  return points;
}

const char* nextPoint(std::size_t clicked) {
  if (clicked == 0) return QT_TRANSLATE_NOOP("Tool", "first point");
  return clicked == 1 ? QT_TRANSLATE_NOOP("Tool", "second point") : QT_TRANSLATE_NOOP("Tool", "third point");
}

}  // namespace

std::size_t MeasureTool::wanted() const {
  return m_mode == Mode::Thickness ? 1 : m_mode == Mode::PointAngle ? 3 : 2;
}

std::vector<SurfacePoint> MeasureTool::points() const {
  std::vector<SurfacePoint> all = m_clicked;
  if (m_hovered && all.size() < wanted()) all.push_back(*m_hovered);
  return all;
}

std::optional<double> MeasureTool::distance() const {
  const std::vector<SurfacePoint> p = points();
  if (m_mode != Mode::Distance || p.size() < 2) return std::nullopt;
  return (p[1].point - p[0].point).stableNorm();
}

std::optional<double> MeasureTool::angle() const {
  const std::vector<SurfacePoint> p = points();
  if (p.size() < wanted()) return std::nullopt;
  if (m_mode == Mode::PointAngle) {
    const Vec3 a = p[0].point - p[1].point, b = p[2].point - p[1].point;
    if (a.isZero(0.0) || b.isZero(0.0)) return std::nullopt;
    return angleBetween(a, b);
  }
  if (m_mode != Mode::FaceAngle || p[0].normal.isZero(0.0) || p[1].normal.isZero(0.0)) return std::nullopt;
  return angleBetween(p[0].normal, -p[1].normal);
}

std::optional<WallThickness> MeasureTool::thickness() const {
  const std::vector<SurfacePoint> p = points();
  return m_mode == Mode::Thickness && !p.empty() ? m_services.thickness(p[0]) : std::nullopt;
}

SnapTargets MeasureTool::snapTargets() const {
  return isOfPoints() ? SnapTargets{.corners = true, .edges = true} : SnapTargets{.faces = true};
}

// A point that attracts the tip is measured exactly: a ray through the outermost edge may miss the surface.
std::optional<SurfacePoint> MeasureTool::pointAt(const PointerEvent& event) const {
  if (event.held && isOfPoints()) return SurfacePoint{*event.held, Vec3::Zero(), kNone};
  return m_services.pick(event.ray);
}

void MeasureTool::start() {
  m_clicked.clear();
  m_hovered.reset();
}

ToolReply MeasureTool::pointer(const PointerEvent& event) {
  m_pixel = event.pixel;
  if (event.kind == PointerEvent::Kind::Hover || event.kind == PointerEvent::Kind::Leave) {
    m_hovered = event.kind == PointerEvent::Kind::Hover ? pointAt(event) : std::nullopt;
    return ToolReply::Used;
  }
  if (event.kind != PointerEvent::Kind::Press || event.button != PointerButton::First) return ToolReply::Ignored;
  const auto point = pointAt(event);
  if (!point) return ToolReply::Ignored;  // the camera's
  if (m_clicked.size() == wanted()) m_clicked.clear();
  m_clicked.push_back(*point);
  return ToolReply::Used;
}

ToolReply MeasureTool::perform(std::string_view action) {
  if (action == "revert" && !m_clicked.empty()) {
    m_clicked.clear();
    return ToolReply::Used;
  }
  return action == "revert" || action == "commit" ? ToolReply::Finished : ToolReply::Ignored;
}

std::span<const ToolKey> MeasureTool::keys() {
  return kMeasureKeys;
}

std::vector<ToolAction> MeasureTool::actions() const {
  const std::size_t clicked = m_clicked.size() == wanted() ? 0 : m_clicked.size();
  const char* next =
      m_mode == Mode::Thickness ? QT_TRANSLATE_NOOP("Tool", "keep this measurement") : nextPoint(clicked);
  if (m_mode == Mode::FaceAngle) {
    next = clicked == 0 ? QT_TRANSLATE_NOOP("Tool", "first face") : QT_TRANSLATE_NOOP("Tool", "second face");
  }
  return {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Click"), next},
      actionOf(kMeasureKeys, "commit"),
      actionOf(kMeasureKeys, "revert", true, m_clicked.empty() ? QT_TRANSLATE_NOOP("Tool", "done") : nullptr),
  };
}

// Faces are shown by lines that stand on them, an angle by an arc between its sides, a wall by the line through it and
// the circle of the ball.
ToolPreview MeasureTool::preview() const {
  ToolPreview preview;
  const std::vector<SurfacePoint> p = points();
  if (m_mode == Mode::FaceAngle) {
    for (const SurfacePoint& each : p) {
      preview.lines.push_back({each.point, each.point + kNormalPixels * m_pixel * each.normal});
    }
  } else if (const auto wall = thickness()) {
    const Vec3 inwards = wall->opposite - p[0].point;
    preview.lines.push_back({p[0].point, wall->opposite});
    preview.lines.push_back(
        arc(wall->ballCentre, -inwards, inwards.unitOrthogonal(), 0.5 * wall->ballDiameter, 2.0 * std::numbers::pi));
  } else if (m_mode != Mode::Thickness && p.size() > 1) {
    preview.lines.emplace_back();
    for (const SurfacePoint& each : p) preview.lines[0].push_back(each.point);
    if (angle()) addAngle(preview, p);
  }
  return preview;
}

void MeasureTool::addAngle(ToolPreview& preview, const std::vector<SurfacePoint>& p) const {
  const Vec3 a = p[0].point - p[1].point, b = p[2].point - p[1].point;
  const double radius = std::min({kArcPixels * m_pixel, 0.5 * a.norm(), 0.5 * b.norm()});
  preview.lines.push_back(arc(p[1].point, a, b, radius, *angle()));
}

std::vector<Property> MeasureTool::settings() const {
  Property mode;
  mode.id = "mode";
  mode.label = QT_TRANSLATE_NOOP("Property", "Measure");
  mode.value = static_cast<double>(m_mode);
  mode.choices = {QT_TRANSLATE_NOOP("Property", "Distance"), QT_TRANSLATE_NOOP("Property", "Angle of three points")};
  if (m_services.thickness) {
    mode.choices.push_back(QT_TRANSLATE_NOOP("Property", "Angle between two faces"));
    mode.choices.push_back(QT_TRANSLATE_NOOP("Property", "Wall thickness"));
  }
  std::vector<Property> all{mode};
  if (const auto mm = distance()) {
    all.push_back(figure("distance", QT_TRANSLATE_NOOP("Property", "Distance"), *mm, Quantity::Length));
  }
  if (const auto radian = angle()) {
    all.push_back(figure("angle", QT_TRANSLATE_NOOP("Property", "Angle"), *radian, Quantity::Angle));
  }
  if (const auto wall = thickness()) {
    all.push_back(
        figure("thickness", QT_TRANSLATE_NOOP("Property", "Along a ray"), wall->alongNormal, Quantity::Length));
    all.push_back(figure("ball", QT_TRANSLATE_NOOP("Property", "Largest inscribed sphere"), wall->ballDiameter,
                         Quantity::Length));
    all.back().prefix = "⌀";
  }
  return all;
}

void MeasureTool::setSetting(std::string_view id, const PropertyValue& value) {
  const double* index = std::get_if<double>(&value);
  const double count = m_services.thickness ? 4.0 : 2.0;
  if (id != "mode" || !index || !(*index >= 0.0 && *index < count)) return;
  m_mode = static_cast<Mode>(static_cast<int>(*index));
  start();
}

}  // namespace handwheel
