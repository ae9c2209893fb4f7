// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/ProcessPathTool.h"

#include "base/NumberText.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellArms.h"
#include "document/scene/BodyDisplay.h"
#include "planning/ToolTrack.h"
#include "tools/cell/ProcessPathSettings.h"
#include "tools/cell/path/DefaultClearance.h"

#include <QtGlobal>
#include <algorithm>
#include <limits>

namespace handwheel {

namespace {

constexpr ToolKey kProcessKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "plan the path along the curve")},
    {"removeLast", "Backspace", QT_TRANSLATE_NOOP("Tool", "remove the last point")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "choose another curve")},
};

constexpr double kEdgePixels = 6.0;  // Tolerance of the pointer beside an edge
constexpr double kDrawnStep = 12.0;  // Pixels between points of a curve that is drawn in one stroke

}  // namespace

ProcessPathTool::ProcessPathTool(const RobotCellDocument& document, ProcessPathServices services)
    : m_document(document), m_services(std::move(services)), m_values(processPathOperation()) {
  m_values.setValid("clearance", defaultClearance(document.robot(), *document.plans(), m_values.number("standoff")));
}

std::span<const ToolKey> ProcessPathTool::keys() {
  return kProcessKeys;
}

// On a part that the robot does not carry.
std::optional<ProcessPathTool::BodyPoint> ProcessPathTool::bodyPointAt(const PointerEvent& event) const {
  const auto hit = event.ray.isUsable() ? m_services.pick(event.ray) : std::nullopt;
  const auto id = hit ? bodyOfPart(hit->part) : std::nullopt;
  const BodyPointer body = id ? m_document.bodies().withId(*id) : nullptr;
  if (!body || carrierOf(*body, m_document.robot().model) != kNone) return std::nullopt;
  return BodyPoint{*id, event.held.value_or(hit->point)};
}

// On an outline every second point under the pointer is beside the part, or on an object behind it.
std::optional<ProcessPathTool::BodyPoint> ProcessPathTool::bodyPointNear(const PointerEvent& event) const {
  const auto at = bodyPointAt(event);
  if (m_values.whole("along") != kAlongEdge || event.device || !event.ray.isUsable()) return at;
  const Ray& ray = event.ray;
  const Vec3 aim = at ? at->point : Vec3(ray.origin + std::max(event.focus, 1.0) * ray.direction.normalized());
  const PickRay seen = event.pickRay();
  const auto pixelsTo = [&](const BodyPoint& bodyPoint) {
    double least = std::numeric_limits<double>::max();
    const SurfaceTrack track = trackAt(bodyPoint);
    for (std::size_t i = 1; i < track.points.size(); ++i) {
      const Vec3 &a = track.points[i - 1].position, along = track.points[i].position - a;
      const double share = std::clamp(along.dot(bodyPoint.point - a) / std::max(along.squaredNorm(), 1e-30), 0.0, 1.0);
      const double pixel = seen.pixelAt(bodyPoint.point);
      if (pixel > 0.0) least = std::min(least, (a + share * along - bodyPoint.point).norm() / pixel);
    }
    return least;
  };
  BodyPoint nearest = at.value_or(BodyPoint());
  bool isFound = at.has_value();
  double least = at ? std::max(pixelsTo(*at), kEdgePixels) : std::numeric_limits<double>::max();
  const Vec3 right = ray.direction.unitOrthogonal(), up = ray.direction.normalized().cross(right);
  for (const auto& [x, y] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
    PointerEvent beside = event;
    const Vec3 off = kEdgePixels * seen.pixelAt(aim) * (x * right + y * up);
    if (event.eye)
      beside.ray.direction = (aim + off - ray.origin).normalized();
    else
      beside.ray.origin += off;
    const auto bodyPoint = bodyPointAt(beside);
    if (!bodyPoint || (at && bodyPoint->body == at->body)) continue;  // The nearest edge of the same part is known
    const double pixels = pixelsTo(*bodyPoint);
    if (pixels < least && pixels <= 2.0 * kEdgePixels) {
      least = pixels;
      nearest = *bodyPoint;
      isFound = true;
    }
  }
  return isFound ? std::optional(nearest) : std::nullopt;
}

SurfaceTrack ProcessPathTool::trackAt(const BodyPoint& bodyPoint) const {
  const BodyPointer body = m_document.bodies().withId(bodyPoint.body);
  const auto surface = body ? m_services.surface(body) : nullptr;
  if (!surface) return {};
  OperationValues values = m_values;
  values.setValid("near", std::vector<double>{bodyPoint.point.x(), bodyPoint.point.y(), bodyPoint.point.z()});
  Result<SurfaceTrack> track = trackOn(surface, *body, values);
  return track ? std::move(track).value() : SurfaceTrack{};
}

void ProcessPathTool::beginDrawing() {
  m_through.clear();
  m_drawn.clear();
  m_drawnOn = m_chosen ? m_document.bodies().withId(m_chosen->body) : nullptr;
  const auto surface = m_drawnOn ? m_services.surface(m_drawnOn) : nullptr;
  if (surface) m_drawn.emplace_back(surface, m_drawnOn->pose.inverse(Eigen::Isometry) * m_chosen->point);
}

bool ProcessPathTool::drawTo(const BodyPoint& bodyPoint) {
  if (m_drawn.empty() || bodyPoint.body != m_chosen->body) return false;
  DrawnCurve longer = m_drawn.back();
  if (!longer.goOnTo(m_drawnOn->pose.inverse(Eigen::Isometry) * bodyPoint.point)) return false;
  m_drawn.push_back(std::move(longer));
  m_through.push_back(bodyPoint.point);
  return true;
}

// Includes the piece to the point under the pointer.
SurfaceTrack ProcessPathTool::drawnTrack() const {
  if (m_drawn.empty()) return {};
  const Pose toBody = m_drawnOn->pose.inverse(Eigen::Isometry);
  DrawnCurve curve = m_drawn.back();
  if (m_hovered && m_hovered->body == m_chosen->body) curve.goOnTo(toBody * m_hovered->point);
  return finishedTrack(curve.track(), toBody * m_chosen->point, *m_drawnOn, m_values);
}

void ProcessPathTool::look() {
  const auto& bodyPoint = m_chosen ? m_chosen : m_hovered;
  if (isDrawing())
    m_track = drawnTrack();
  else
    m_track = bodyPoint ? trackAt(*bodyPoint) : SurfaceTrack{};
}

// A part whose surface was not prepared yet when it was pointed to may be by now.
SurfaceTrack ProcessPathTool::shown() const {
  const bool isLate = m_track.points.empty() && m_hovered && !m_chosen && !isDrawing();
  return isLate ? trackAt(*m_hovered) : m_track;
}

ToolReply ProcessPathTool::pointer(const PointerEvent& event) {
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
    case PointerEvent::Kind::Leave:
      if (m_chosen && !isDrawing()) return ToolReply::Ignored;
      m_hovered = event.kind == PointerEvent::Kind::Hover ? bodyPointNear(event) : std::nullopt;
      look();
      return ToolReply::Used;
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Drag:
      return drag(event);
    case PointerEvent::Kind::Release:
      return m_chosen ? ToolReply::Used : ToolReply::Ignored;
    case PointerEvent::Kind::DoubleClick:
      break;
  }
  return ToolReply::Ignored;
}

ToolReply ProcessPathTool::press(const PointerEvent& event) {
  const auto bodyPoint = event.button == PointerButton::First ? bodyPointNear(event) : std::nullopt;
  if (!bodyPoint) return ToolReply::Ignored;  // the camera's
  if (isDrawing() && m_chosen) {
    m_hovered.reset();
    drawTo(*bodyPoint);
  } else if (isDrawing() || !trackAt(*bodyPoint).points.empty()) {
    m_chosen = bodyPoint;
    beginDrawing();
  } else {
    return ToolReply::Ignored;
  }
  look();
  return ToolReply::Used;
}

ToolReply ProcessPathTool::drag(const PointerEvent& event) {
  if (!m_chosen) return ToolReply::Ignored;
  const auto bodyPoint = isDrawing() ? bodyPointAt(event) : std::nullopt;
  const Vec3& last = m_through.empty() ? m_chosen->point : m_through.back();
  if (bodyPoint && (bodyPoint->point - last).norm() >= kDrawnStep * event.pixel && drawTo(*bodyPoint)) look();
  return ToolReply::Used;
}

ToolReply ProcessPathTool::perform(std::string_view action) {
  if (action == "revert") {
    if (!m_chosen) return ToolReply::Finished;
    m_chosen.reset();
    beginDrawing();
    look();
    return ToolReply::Used;
  }
  if (action == "removeLast") {
    if (m_through.empty()) return ToolReply::Ignored;
    m_through.pop_back();
    m_drawn.pop_back();
    look();
    return ToolReply::Used;
  }
  m_hovered.reset();
  look();
  if (action != "commit" || !m_chosen || m_track.points.empty()) return ToolReply::Ignored;
  OperationValues values = m_values;
  values.setValid("part", std::to_string(m_chosen->body));
  const Vec3& at = m_chosen->point;
  values.setValid("near", std::vector<double>{at.x(), at.y(), at.z()});
  if (isDrawing()) {
    std::string through;
    for (const Vec3& point : m_through) {
      through += through.empty() ? "" : ";";
      through += shortestText(point.x()) + "," + shortestText(point.y()) + "," + shortestText(point.z());
    }
    values.setValid("through", through);
  }
  m_services.plan(values);
  return ToolReply::Used;
}

std::vector<ToolAction> ProcessPathTool::actions() const {
  const bool isChosen = m_chosen && !m_track.points.empty();
  std::vector<ToolAction> all;
  if (isDrawing()) {
    all.push_back({"", QT_TRANSLATE_NOOP("ToolInput", "Click"),
                   m_chosen ? QT_TRANSLATE_NOOP("Tool", "draw the curve to there")
                            : QT_TRANSLATE_NOOP("Tool", "begin a curve on a part")});
    all.push_back({"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "draw in one go")});
  } else {
    all.push_back({"", QT_TRANSLATE_NOOP("ToolInput", "Click"), QT_TRANSLATE_NOOP("Tool", "choose a curve on a part")});
  }
  all.push_back(actionOf(kProcessKeys, "commit", isChosen));
  if (isDrawing()) all.push_back(actionOf(kProcessKeys, "removeLast", !m_through.empty()));
  all.push_back(actionOf(kProcessKeys, "revert", true, m_chosen ? nullptr : QT_TRANSLATE_NOOP("Tool", "done")));
  return all;
}

// The curve, and how the tool is held at points of it.
ToolPreview ProcessPathTool::preview() const {
  constexpr double kShownTool = 30.0;     // mm of its axis
  constexpr std::size_t kMostShown = 60;  // tools
  ToolPreview preview;
  const SurfaceTrack track = shown();
  if (track.points.size() < 2) return preview;
  std::vector<Vec3> curve;
  for (const TrackPoint& point : track.points) curve.push_back(point.position);
  preview.lines.push_back(std::move(curve));
  const std::vector<Pose> poses = toolPoses(track, {.lead = m_values.number("lead"),
                                                    .tilt = m_values.number("tilt"),
                                                    .spin = m_values.number("spin"),
                                                    .standoff = m_values.number("standoff")});
  for (std::size_t i = 0; i < poses.size(); i += poses.size() / kMostShown + 1)
    preview.lines.push_back({poses[i].translation(), poses[i] * Vec3(0.0, 0.0, -kShownTool)});
  return preview;
}

std::vector<std::string> ProcessPathTool::ends() const {
  return processEnds(m_document.robot(), *m_document.plans());
}

std::vector<Property> ProcessPathTool::settings() const {
  std::vector<Property> all = processPathSettings(m_values, ends());
  if (isJagged(m_track)) {
    all.front().problem = QT_TRANSLATE_NOOP(
        "Property", "it turns to and fro again and again: a section, or a larger tolerance, is smoother");
  }
  return all;
}

void ProcessPathTool::setSetting(std::string_view id, const PropertyValue& value) {
  const bool wasDrawing = isDrawing();
  takeProcessSetting(m_values, ends(), id, value);
  if (isDrawing() != wasDrawing) beginDrawing();
  look();
}

void ProcessPathTool::documentChanged() {
  if (m_chosen && !m_document.bodies().withId(m_chosen->body)) m_chosen.reset();
  m_hovered.reset();
  if (!m_chosen || m_document.bodies().withId(m_chosen->body) != m_drawnOn) beginDrawing();
  look();
}

}  // namespace handwheel
