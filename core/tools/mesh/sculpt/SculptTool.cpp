// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/sculpt/SculptTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/mesh/MeshPreview.h"
#include "tools/mesh/MeshSelection.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {
namespace {

constexpr double kFirstRadius = 0.05;  // fraction of the diagonal of the model
constexpr double kDabSpacing = 0.25;   // fraction of the radius
constexpr int kMostDabs = 8;           // to an event
// Faces that the dabs of one event may go over, so that the window keeps up: some 20 ms.
constexpr std::size_t kMostFacesMet = 20'000;
constexpr double kStiffness = 0.05;  // N/mm

const char* textOf(SculptSettings::Brush brush) {
  switch (brush) {
    case SculptSettings::Brush::Smooth:
      return QT_TRANSLATE_NOOP("Tool", "Smooth surface");
    case SculptSettings::Brush::Inflate:
      return QT_TRANSLATE_NOOP("Tool", "Inflate surface");
    case SculptSettings::Brush::Flatten:
      return QT_TRANSLATE_NOOP("Tool", "Flatten surface");
    case SculptSettings::Brush::Drag:
      break;
  }
  return QT_TRANSLATE_NOOP("Tool", "Drag surface");
}

// 1, 2 or 5 times a power of ten.
double nearRoundNumber(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value))), digits = value / power;
  return power * (digits < 1.5 ? 1.0 : digits < 3.5 ? 2.0 : digits < 7.5 ? 5.0 : 10.0);
}

}  // namespace

SculptTool::SculptTool(MeshDocument& document, MeshServices services, FaceSelection patch)
    : m_document(document), m_services(std::move(services)), m_levels(document.mesh(), {}), m_known(document.mesh()) {
  const Box& box = document.defects().box;
  if (!box.isEmpty()) m_settings.set("radius", nearRoundNumber(kFirstRadius * box.diagonal().norm()));
  patch.dropDead(m_known);
  const PatchLevels* remembered = m_document.levels(patch);
  setLevels(remembered ? *remembered : PatchLevels(m_known, std::move(patch)));
}

SculptTool::~SculptTool() {
  if (m_job) m_services.cancel();
}

void SculptTool::setLevels(PatchLevels levels) {
  const bool isSamePatch = levels.patch() == m_levels.patch();
  m_levels = std::move(levels);
  m_level = m_levels.finest();
  if (isSamePatch) return;
  m_outline = outlinesOf(m_levels.mesh(), m_levels.patch());
  m_aspect = outlineAspect(m_levels.mesh(), m_levels.patch());
}

ToolReply SculptTool::pointer(const PointerEvent& event) {
  switch (event.kind) {
    case PointerEvent::Kind::Press:
    case PointerEvent::Kind::DoubleClick:
      return press(event);
    case PointerEvent::Kind::Drag:
      return drag(event);
    case PointerEvent::Kind::Release:
      return release(event);
    case PointerEvent::Kind::Hover:
      m_hovered = positionAt(event.ray);
      return ToolReply::Used;
    case PointerEvent::Kind::Leave:
      break;
  }
  m_hovered.reset();
  return ToolReply::Used;
}

std::optional<SurfacePosition> SculptTool::positionAt(const Ray& ray) const {
  const auto faces = m_services.faces();
  return faces ? hitOn(levels().mesh(), *faces, ray, m_settings.radius) : std::nullopt;
}

SculptStroke::Settings SculptTool::strokeSettings(const Modifiers& modifiers) const {
  SculptStroke::Settings stroke;
  stroke.brush = modifiers.shift ? SculptSettings::Brush::Smooth : m_settings.brush;
  stroke.radius = m_settings.radius;
  stroke.strength = modifiers.control ? -m_settings.strength : m_settings.strength;
  stroke.movesBorder = m_settings.movesBorder;
  stroke.level = m_level;
  stroke.numbers = m_document.fileNumbers();
  return stroke;
}

ToolReply SculptTool::press(const PointerEvent& event) {
  if (event.device && event.button == PointerButton::Second) return perform("commit");
  const bool wasBusy = m_stroke.has_value();
  dropStroke();
  if (event.button != PointerButton::First) return wasBusy ? ToolReply::Used : ToolReply::Ignored;
  const auto position = positionAt(event.ray);
  if (!position) return ToolReply::Ignored;  // the camera may have it
  cancelJob();
  m_problem = nullptr;
  m_crossings = 0;
  m_stroke.emplace(m_levels, strokeSettings(event.modifiers), *position, event.ray);
  m_last = event.ray;
  if (event.device) m_tip = event.device->translation();
  m_hovered.reset();  // no circle where the surface is pulled away from
  if (m_stroke->settings().brush != SculptSettings::Brush::Drag) {
    m_stroke->dab(*position);
    m_hovered = position;
  }
  showPreviewMesh();
  return ToolReply::Used;
}

ToolReply SculptTool::drag(const PointerEvent& event) {
  if (!m_stroke) return ToolReply::Ignored;
  if (!event.ray.isUsable()) return ToolReply::Used;
  if (m_stroke->settings().brush != SculptSettings::Brush::Drag) {
    dabAlong(event.ray);
  } else if (event.device && m_tip) {
    m_stroke->dragBy(event.device->translation() - *m_tip);
  } else {
    m_stroke->dragTo(event.ray);
  }
  showPreviewMesh();
  return ToolReply::Used;
}

// Dabs at even distances on the path from the last one; the rays between are those of a straight line on the screen.
void SculptTool::dabAlong(const Ray& ray) {
  const auto goal = positionAt(ray);
  if (!goal) return;
  const double travel = m_hovered ? (goal->point - m_hovered->point).norm() : 0.0;
  const int dabs = static_cast<int>(std::min(travel / (kDabSpacing * m_settings.radius), double{kMostDabs}));
  const std::size_t before = m_stroke->facesMet();
  const Ray from = m_last;
  for (int i = 1; i <= dabs && m_stroke->facesMet() - before < kMostFacesMet; ++i) {
    const double share = static_cast<double>(i) / dabs;
    m_last.origin = from.origin + share * (ray.origin - from.origin);
    m_last.direction = (from.direction + share * (ray.direction - from.direction)).stableNormalized();
    const auto position = positionAt(m_last);
    if (!position) continue;
    m_stroke->dab(*position);
    m_hovered = position;
  }
}

ToolReply SculptTool::release(const PointerEvent& event) {
  if (event.button != PointerButton::First || !m_stroke) return ToolReply::Ignored;
  drag(event);
  const SculptStroke stroke = *std::exchange(m_stroke, std::nullopt);
  m_tip.reset();
  if (stroke.changedAnything()) {
    take(textOf(stroke.settings().brush), sculpted(stroke));
  } else {
    showPreviewMesh();
  }
  return ToolReply::Used;
}

void SculptTool::dropStroke() {
  m_stroke.reset();
  m_tip.reset();
  showPreviewMesh();
}

void SculptTool::showPreviewMesh() {
  m_previewMesh.reset();
  if (!m_stroke && m_waiting.empty()) return;
  auto made = std::make_shared<PreviewMesh>(PreviewMesh{levels().mesh(), m_touched});
  if (m_stroke) made->touched.add(m_stroke->touched());
  m_previewMesh = std::move(made);
}

std::vector<DeviceSpring> SculptTool::forces() const {
  if (!m_stroke || m_stroke->settings().brush != SculptSettings::Brush::Drag) return {};
  return {{m_tip.value_or(m_stroke->start().point), kStiffness}};
}

ToolPreview SculptTool::preview() const {
  ToolPreview preview;
  const auto onMesh = std::make_shared<MeshPreview>();
  onMesh->previewMesh = m_previewMesh;
  preview.ofKind = onMesh;
  preview.lines = m_outline;
  if (m_hovered) preview.circle = {m_hovered->point, m_settings.radius};
  return preview;
}

}  // namespace handwheel
