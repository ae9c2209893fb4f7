// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/SelectTool.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/boundary/HolePick.h"
#include "mesh/selection/RegionGrowing.h"

#include <QtGlobal>
#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

// A region with more faces than this is not shown before it is selected: growing it takes a millisecond.
constexpr std::size_t kMostHovered = 20'000;

double alongRay(const Ray& ray, const Vec3& p) {
  return (p - ray.origin).dot(ray.direction);
}

}  // namespace

SelectTool::SelectTool(MeshDocument& document, MeshServices services, MeshSelection selection)
    : m_document(document), m_services(std::move(services)), m_steps(std::move(selection)) {
  const Box& box = document.defects().box;
  if (!box.isEmpty()) m_settings.set("brush_length", 0.02 * box.diagonal().norm());
}

SelectTool::~SelectTool() {
  if (m_job) m_services.cancel();
}

// A lasso is drawn in the air.
SnapTargets SelectTool::snapTargets() const {
  if (m_settings.mode == Mode::Lasso) return {};
  return {.borderEdges = m_settings.mode == Mode::Click, .faces = true};
}

std::vector<Property> SelectTool::settings() const {
  std::vector<Property> all = m_settings.properties();
  all.push_back({.id = "selected",
                 .group = {},
                 .label = QT_TRANSLATE_NOOP("Property", "Selected triangles"),
                 .value = static_cast<double>(selection().faces.count()),
                 .editable = false});
  return all;
}

const HalfEdgeMesh& SelectTool::mesh() const {
  return m_document.mesh();
}

void SelectTool::select(MeshSelection selection) {
  dropGesture();
  cancelJob();
  selection.dropDead(mesh(), m_document.defects().loops);
  m_steps.change(std::move(selection));
  reportUpdated();
}

SelectTool::Combine SelectTool::combineOf(const Modifiers& modifiers) {
  return modifiers.control ? Combine::Remove : modifiers.shift ? Combine::Add : Combine::Replace;
}

ToolReply SelectTool::pointer(const PointerEvent& event) {
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
      return hover(event);
    case PointerEvent::Kind::Press:
    case PointerEvent::Kind::DoubleClick:
      return press(event);
    case PointerEvent::Kind::Drag:
      return drag(event);
    case PointerEvent::Kind::Release:
      return release(event);
    case PointerEvent::Kind::Leave:
      break;
  }
  m_hovered = {};
  m_hoveredLoop.reset();
  m_circle.reset();
  return ToolReply::Used;
}

SelectTool::Target SelectTool::targetOf(const PointerEvent& event) const {
  Target target;
  const auto faces = m_services.faces();
  if (!faces || !event.ray.isUsable()) return target;
  if (m_settings.mode == Mode::Click) {
    const auto& loops = m_document.defects().loops;
    if (const auto loop = pickHole(mesh(), loops, *faces, event.pickRay())) {
      target.loop = keyOf(mesh(), loops[*loop]);
      return target;
    }
  }
  target.hit = faces->firstHit(event.ray);
  // The hierarchy may be older than the mesh.
  const bool isThere = target.hit && target.hit->face < mesh().faceSlots() && mesh().isLive(target.hit->face);
  if (!isThere) target.hit.reset();
  return target;
}

ToolReply SelectTool::hover(const PointerEvent& event) {
  const Target target = targetOf(event);
  m_hoveredLoop = target.loop;
  m_circle.reset();
  if (!target.hit || m_settings.mode == Mode::Brush || m_settings.mode == Mode::Lasso) {
    m_hovered = {};
  } else if (!m_hovered.contains(target.hit->face)) {
    m_hovered = regionOf(target.hit->face);
  }
  if (target.hit && m_settings.mode == Mode::Brush)
    m_circle = {target.hit->point, m_settings.brushRadius(event.pickRay(), target.hit->point)};
  return ToolReply::Used;
}

// Returns the faces that a click there would select, as far as they are quickly found.
FaceSelection SelectTool::regionOf(Face seed) const {
  const GrowthLimit limit{kMostHovered, {}};
  std::optional<FaceSelection> region;
  if (m_settings.mode == Mode::Connected) region = connectedFaces(mesh(), {&seed, 1}, limit);
  if (m_settings.mode == Mode::Angle) region = facesWithinAngle(mesh(), {&seed, 1}, m_settings.angle, limit);
  return region && region->count() < kMostHovered ? *region : FaceSelection{seed};
}

ToolReply SelectTool::press(const PointerEvent& event) {
  if (event.device && event.button == PointerButton::Second)  // poked and deleted, by the hand alone
    return perform(m_steps.present().faces.empty() ? "commit" : "delete");
  const bool wasBusy = m_gesture.index() != 0;
  dropGesture();
  if (event.button != PointerButton::First) return wasBusy ? ToolReply::Used : ToolReply::Ignored;
  const auto faces = m_services.faces();
  if (!faces || !event.ray.isUsable()) return ToolReply::Ignored;

  const Combine how = combineOf(event.modifiers);
  const Target target = targetOf(event);
  if (m_settings.mode == Mode::Lasso) {
    const double toMiddle = faces->bounds().isEmpty() ? 0.0 : alongRay(event.ray, faces->bounds().center());
    const double depth = target.hit ? target.hit->distance : toMiddle;
    m_gesture = Path{faces, {{event.ray}, event.eye, m_settings.through}, how, std::max(0.0, depth)};
  } else if (target.isNothing()) {
    if (m_settings.mode != Mode::Brush) m_gesture = Pressed{target, how};
    return ToolReply::Ignored;  // the camera may have it
  } else if (m_settings.mode == Mode::Brush) {
    cancelJob();
    m_live = how == Combine::Replace ? MeshSelection() : m_steps.present();
    paint(m_gesture.emplace<Stroke>(Stroke{BrushStroke(faces), how}), event);
  } else if (event.kind == PointerEvent::Kind::DoubleClick && m_settings.mode == Mode::Click && target.hit) {
    selectConnected(target.hit->face, how);
  } else {
    m_gesture = Pressed{target, how};
  }
  return ToolReply::Used;
}

void SelectTool::extend(const PointerEvent& event) {
  if (!event.ray.isUsable()) return;
  if (auto* stroke = std::get_if<Stroke>(&m_gesture)) paint(*stroke, event);
  if (auto* path = std::get_if<Path>(&m_gesture)) path->lasso.rays.push_back(event.ray);
}

void SelectTool::paint(Stroke& stroke, const PointerEvent& event) {
  const auto hit = stroke.brush.faces().firstHit(event.ray);
  const Vec3 position = hit ? hit->point : m_circle ? m_circle->first : event.ray.origin;
  const double radius = m_settings.brushRadius(event.pickRay(), position);
  m_circle.reset();
  if (hit) m_circle = {hit->point, radius};
  for (const Face f : stroke.brush.moveTo({event.ray, radius})) {
    if (f >= mesh().faceSlots() || !mesh().isLive(f)) continue;
    if (stroke.how == Combine::Remove) {
      m_live->faces.remove(f);
    } else {
      m_live->faces.add(f);
    }
  }
}

ToolReply SelectTool::drag(const PointerEvent& event) {
  const auto* pressed = std::get_if<Pressed>(&m_gesture);
  if (pressed && pressed->target.isNothing()) m_gesture = {};  // no click, but a turn of the camera
  extend(event);
  return m_gesture.index() != 0 ? ToolReply::Used : ToolReply::Ignored;
}

ToolReply SelectTool::release(const PointerEvent& event) {
  if (event.button != PointerButton::First || m_gesture.index() == 0) return ToolReply::Ignored;
  extend(event);
  const auto gesture = std::exchange(m_gesture, {});
  if (m_live) {
    m_steps.change(*std::exchange(m_live, std::nullopt));
  } else if (const auto* path = std::get_if<Path>(&gesture)) {
    selectLater(
        QT_TRANSLATE_NOOP("Tool", "Selecting by lasso"),
        [faces = path->faces, lasso = path->lasso](Progress p) { return facesInLasso(*faces, lasso, p); }, path->how);
  } else if (const auto* pressed = std::get_if<Pressed>(&gesture)) {
    selectTarget(pressed->target, pressed->how);
  }
  return ToolReply::Used;
}

void SelectTool::dropGesture() {
  m_gesture = {};
  m_live.reset();
}

}  // namespace handwheel
