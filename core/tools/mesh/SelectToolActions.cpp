// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshDocument.h"
#include "mesh/selection/RegionGrowing.h"
#include "tools/mesh/ManualMeshChanges.h"
#include "tools/mesh/MeshPreview.h"
#include "tools/mesh/SelectTool.h"
#include "tools/mesh/repair/DefectFixes.h"

#include <QtGlobal>
#include <utility>

// The actions of SelectTool other than following the pointer.
namespace handwheel {
namespace {

constexpr double kBrushStep = 1.25;  // from one size to the next by key
constexpr ToolKey kSelectKeys[] = {
    {"smaller", "[", QT_TRANSLATE_NOOP("Tool", "smaller brush")},
    {"larger", "]", QT_TRANSLATE_NOOP("Tool", "larger brush")},
    {"all", "Ctrl+A", QT_TRANSLATE_NOOP("Tool", "select all")},
    {"invert", "Ctrl+I", QT_TRANSLATE_NOOP("Tool", "invert the selection")},
    {"grow", "Ctrl++", QT_TRANSLATE_NOOP("Tool", "grow by one ring")},
    {"shrink", "Ctrl+-", QT_TRANSLATE_NOOP("Tool", "shrink by one ring")},
    {"previous", "Backspace", QT_TRANSLATE_NOOP("Tool", "previous selection")},
    {"next", "Shift+Backspace", QT_TRANSLATE_NOOP("Tool", "next selection")},
    {"delete", "Del", QT_TRANSLATE_NOOP("Tool", "delete the faces")},
    {"reverse", "Shift+F", QT_TRANSLATE_NOOP("Tool", "reverse the shells of the selected faces")},
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "done")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "clear the selection")},
};

struct PointerHints {
  const char *click, *add, *remove, *effect;
};

PointerHints hintsOf(SelectSettings::Mode mode) {
  using Mode = SelectSettings::Mode;
  const PointerHints byClick = {QT_TRANSLATE_NOOP("ToolInput", "Click"), QT_TRANSLATE_NOOP("ToolInput", "Shift+click"),
                                QT_TRANSLATE_NOOP("ToolInput", "Ctrl+click"),
                                QT_TRANSLATE_NOOP("Tool", "select a face or a hole")};
  const PointerHints byDrag = {QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("ToolInput", "Shift+drag"),
                               QT_TRANSLATE_NOOP("ToolInput", "Ctrl+drag"), QT_TRANSLATE_NOOP("Tool", "paint faces")};
  const auto with = [](PointerHints hints, const char* effect) {
    hints.effect = effect;
    return hints;
  };
  switch (mode) {
    case Mode::Brush:
      return byDrag;
    case Mode::Lasso:
      return with(byDrag, QT_TRANSLATE_NOOP("Tool", "draw a line around faces"));
    case Mode::Connected:
      return with(byClick, QT_TRANSLATE_NOOP("Tool", "select connected faces"));
    case Mode::Angle:
      return with(byClick, QT_TRANSLATE_NOOP("Tool", "select up to the next sharp edge"));
    case Mode::Click:
      break;
  }
  return byClick;
}

}  // namespace

void SelectTool::selectTarget(const Target& target, Combine how) {
  if (target.loop) return combine({{}, {*target.loop}}, how);
  if (!target.hit) {
    if (how == Combine::Replace) combine({}, how);
    return;
  }
  const Face seed = target.hit->face;
  if (m_settings.mode == Mode::Connected) return selectConnected(seed, how);
  if (m_settings.mode != Mode::Angle) return combine({{seed}, {}}, how);
  selectLater(
      QT_TRANSLATE_NOOP("Tool", "Selecting up to the next sharp edge"),
      [mesh = mesh(), seed, angle = m_settings.angle](Progress p) {
        return facesWithinAngle(mesh, {&seed, 1}, angle, {.progress = p});
      },
      how);
}

void SelectTool::selectConnected(Face seed, Combine how) {
  selectLater(
      QT_TRANSLATE_NOOP("Tool", "Selecting connected faces"),
      [mesh = mesh(), seed](Progress p) {
        return connectedFaces(mesh, {&seed, 1}, {.progress = p});
      },
      how);
}

void SelectTool::selectLater(const char* name, std::function<std::optional<FaceSelection>(Progress)> find,
                             Combine how) {
  cancelJob();
  m_job = std::make_shared<const int>();
  m_services.run({name, [this, how, find = std::move(find), job = std::weak_ptr(m_job)](Progress progress) {
                    const auto found = find(progress);
                    return std::function<void()>([this, how, found, job] {
                      if (job.expired() || !found) return;
                      m_job.reset();
                      MeshSelection selection{*found, {}};
                      selection.faces.dropDead(mesh());  // it may have come of an older version
                      combine(selection, how);
                      reportUpdated();
                    });
                  }});
}

void SelectTool::combine(const MeshSelection& found, Combine how) {
  cancelJob();
  MeshSelection next = how == Combine::Replace ? MeshSelection() : m_steps.present();
  if (how == Combine::Remove) {
    next.remove(found);
  } else {
    next.add(found);
  }
  m_steps.change(std::move(next));
}

void SelectTool::cancelJob() {
  if (!m_job) return;
  m_job.reset();
  m_services.cancel();
}

ToolReply SelectTool::perform(std::string_view action) {
  if (action == "revert") return revert();
  dropGesture();
  if (action == "commit") return ToolReply::Finished;
  if (action == "smaller" || action == "larger") {
    m_settings.scaleBrush(action == "larger" ? kBrushStep : 1.0 / kBrushStep);
    return ToolReply::Used;
  }
  cancelJob();
  const MeshSelection& present = m_steps.present();
  if (action == "all") {
    combine({FaceSelection::all(mesh()), {}}, Combine::Replace);
  } else if (action == "invert") {
    combine({present.faces.inverted(mesh()), {}}, Combine::Replace);
  } else if (action == "grow") {
    combine({grownByRing(mesh(), present.faces), present.loops}, Combine::Replace);
  } else if (action == "shrink") {
    combine({shrunkByRing(mesh(), present.faces), present.loops}, Combine::Replace);
  } else if (action == "previous" || action == "next") {
    step(action == "next");
  } else if (action == "delete") {
    m_services.commit(deleteChange(present.faces, QT_TRANSLATE_NOOP("Tool", "Delete faces")));
  } else if (action == "reverse") {
    m_services.commit(reverseChange(present.faces));
  } else {
    return ToolReply::Ignored;
  }
  return ToolReply::Used;
}

// Step by step out of what is going on.
ToolReply SelectTool::revert() {
  if (m_gesture.index() != 0) {
    dropGesture();
  } else if (m_job) {
    cancelJob();
  } else if (!selection().empty()) {
    combine({}, Combine::Replace);
  } else {
    return ToolReply::Finished;
  }
  return ToolReply::Used;
}

void SelectTool::step(bool forward) {
  if (forward) {
    m_steps.goForward();
  } else {
    m_steps.goBack();
  }
  m_steps.replacePresent(presentAlive());  // its faces may no longer exist
}

MeshSelection SelectTool::presentAlive() const {
  MeshSelection present = m_steps.present();
  present.dropDead(mesh(), m_document.defects().loops);
  return present;
}

std::span<const ToolKey> SelectTool::keys() {
  return kSelectKeys;
}

std::vector<ToolAction> SelectTool::actions() const {
  const bool some = !selection().faces.empty();
  const PointerHints hints = hintsOf(m_settings.mode);
  std::vector<ToolAction> all = {
      {"", hints.click, hints.effect},
      {"", hints.add, QT_TRANSLATE_NOOP("Tool", "add to the selection")},
      {"", hints.remove, QT_TRANSLATE_NOOP("Tool", "remove from the selection")},
  };
  if (m_settings.mode == Mode::Click)
    all.push_back({"", QT_TRANSLATE_NOOP("ToolInput", "Double-click"), hintsOf(Mode::Connected).effect});
  if (m_settings.mode == Mode::Brush) {
    all.push_back(actionOf(kSelectKeys, "smaller"));
    all.push_back(actionOf(kSelectKeys, "larger"));
  }
  const std::vector<ToolAction> common = {
      actionOf(kSelectKeys, "all"),
      actionOf(kSelectKeys, "invert"),
      actionOf(kSelectKeys, "grow", some),
      actionOf(kSelectKeys, "shrink", some),
      actionOf(kSelectKeys, "previous", m_steps.canGoBack()),
      actionOf(kSelectKeys, "next", m_steps.canGoForward()),
      actionOf(kSelectKeys, "delete", some),
      actionOf(kSelectKeys, "reverse", some),
      actionOf(kSelectKeys, "commit"),
      actionOf(kSelectKeys, "revert", true, selection().empty() ? QT_TRANSLATE_NOOP("Tool", "done") : nullptr),
  };
  all.insert(all.end(), common.begin(), common.end());
  return all;
}

ToolPreview SelectTool::preview() const {
  ToolPreview preview;
  const auto faces = std::make_shared<MeshPreview>();
  faces->selected = selection().faces;
  faces->highlighted = m_hovered;
  preview.ofKind = faces;
  preview.circle = m_circle;
  std::set<Vertex> keys = selection().loops;
  if (m_hoveredLoop) keys.insert(*m_hoveredLoop);
  if (!keys.empty())
    for (const BoundaryLoop& loop : m_document.defects().loops)
      if (keys.count(keyOf(mesh(), loop)) != 0) preview.lines.push_back(outlineOf(mesh(), loop));
  if (const auto* path = std::get_if<Path>(&m_gesture)) {
    std::vector<Vec3>& line = preview.lines.emplace_back();
    for (const Ray& ray : path->lasso.rays) line.push_back(ray.origin + path->depth * ray.direction);
    line.push_back(line.front());
  }
  return preview;
}

void SelectTool::setSetting(std::string_view id, const PropertyValue& value) {
  if (!m_settings.set(id, value)) return;
  dropGesture();
  m_hovered = {};
  m_hoveredLoop.reset();
}

void SelectTool::documentChanged() {
  dropGesture();
  cancelJob();
  m_hovered = {};
  m_hoveredLoop.reset();
  m_circle.reset();
  m_steps.change(presentAlive());  // a step, so that one can select again what an undo brings back
}

}  // namespace handwheel
