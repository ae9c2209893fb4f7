// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/demo/RepairDemo.h"

#include "theme/Theme.h"
#include "tools/mesh/FillHoleTool.h"
#include "tools/mesh/MeshSelection.h"
#include "tools/mesh/sculpt/SculptTool.h"
#include "viewport/Viewport.h"
#include "window/ActionToolTip.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/Samples.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/repair/RepairJobs.h"
#include "window/tools/ToolHost.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::uint32_t kFirstLook = 1u << 0, kSecond = 1u << 1;
constexpr double kClick = 0.2;                 // s that a button is held
constexpr double kLookTime = 1.4;              // s to see what was proposed or done
constexpr double kNear = 0.6;                  // fraction of the size of the hole that the camera shows
constexpr double kBrush = 0.25, kPull = 0.06;  // fraction of the diagonal of the hole
constexpr int kStrokes = 5;                    // over the seam

DemoStep click(std::function<std::optional<Vec3>()> goal, std::function<bool()> isReady = {}) {
  DemoStep step;
  step.isReady = std::move(isReady);
  step.goal = std::move(goal);
  step.rest = kClick;
  return step;
}

DemoStep press(std::uint32_t buttons) {
  DemoStep step;
  step.buttons = buttons;
  step.rest = kClick;
  return step;
}

DemoStep rest(double seconds, std::function<bool()> isReady = {}) {
  DemoStep step;
  step.isReady = std::move(isReady);
  step.rest = seconds;
  return step;
}

}  // namespace

RepairDemo::RepairDemo(const WindowContext& parts, const RepairJobs& jobs, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_jobs(jobs),
      m_hand(parts.haptics, parts.viewport, this),
      m_action(tr("&Watch the hand repair a scan"), this),
      m_stop(tr("Stop"), this) {
  prepare(m_action, "watchRepair", "hand",
          tr("The simulated hand repairs a hole of the sample with the same tools that you have"));
  m_action.setEnabled(!samplePath(kScanSample).isEmpty());
  m_stop.setObjectName(QStringLiteral("stopShow"));
  connect(&m_action, &QAction::triggered, this, &RepairDemo::start);
  connect(&m_stop, &QAction::triggered, &m_hand, &ScriptedDeviceDemo::stop);
  connect(&m_hand, &ScriptedDeviceDemo::captionChanged, this, &RepairDemo::changed);
  connect(&m_hand, &ScriptedDeviceDemo::ended, this, &RepairDemo::ended);
}

void RepairDemo::setDocument(MeshTab* document) {
  if (m_document && document != m_document && m_hole.isTaken()) m_hand.stop();  // the user has gone elsewhere
  m_document = document;
}

Suggestion RepairDemo::step() {
  if (!m_hand.isRunning()) return {};
  const QColor& accent = themeColours(currentTheme()).accent;
  return {QStringLiteral("device"), accent, m_hand.caption(), m_hand.detail(), {&m_stop}};
}

void RepairDemo::start() {
  m_hand.stop();
  m_hole.forget();
  m_hand.start(steps());
}

void RepairDemo::ended() {
  m_hole.forget();
  for (const Setting& setting : m_changed) m_parts.tools.choose(setting.tool, setting.id, setting.value);
  m_changed.clear();
  if (m_document) useTool("fillTool");
}

std::vector<DemoStep> RepairDemo::steps() {
  std::vector<DemoStep> steps = {opening()};
  addChoosing(steps);
  addSmoothing(steps);
  addStitching(steps);
  addFilling(steps);
  addSculpting(steps);
  return steps;
}

DemoStep RepairDemo::opening() {
  DemoStep step;
  step.caption = tr("The hand opens the sample");
  step.detail = tr("You can do the same with a device or with the mouse.");
  step.begin = [this] { m_parts.openFile(samplePath(kScanSample)); };
  step.isReady = [this] { return m_document && isSettled() && takeHole(); };
  step.rest = 0.5;
  return step;
}

void RepairDemo::addChoosing(std::vector<DemoStep>& steps) {
  DemoStep go = click([this] { return firstPoint(nextPart()); });
  go.caption = tr("1 of 5: choose the hole");
  go.detail = tr("Boundary vertices attract the tip. The first button chooses the hole.");
  go.begin = [this] {
    useTool("boundaryTool");
    lookFrom(m_hole.outward());
  };
  steps.insert(steps.end(), {go, press(kFirstLook), rest(kLookTime)});
}

void RepairDemo::addSmoothing(std::vector<DemoStep>& steps) {
  DemoStep propose = rest(kLookTime, [this] { return shows("boundary", "held"); });
  propose.caption = tr("2 of 5: smooth its boundary");
  propose.detail = tr("Shift+S shows a preview. The second button applies it.");
  propose.begin = [this] { perform("smooth"); };
  steps.insert(steps.end(), {propose, press(kSecond), rest(kLookTime, [this] { return isSettled(); })});
}

void RepairDemo::addStitching(std::vector<DemoStep>& steps) {
  const auto end = [this](HalfEdge BoundaryPair::*which) {
    return [this, which]() -> std::optional<Vec3> {
      const HalfEdgeMesh& mesh = m_document->document.mesh();
      const BoundaryLoop* part = nextPart();
      const auto pair = part ? DemoHole::waist(mesh, *part) : std::nullopt;
      if (!pair) return std::nullopt;
      return mesh.position(mesh.from((*pair).*which));
    };
  };
  DemoStep take = click(end(&BoundaryPair::a));
  take.caption = tr("3 of 5: stitch");
  take.detail =
      tr("A vertex is pulled to the opposite one: the longer the pull, the stronger the force. The hole is divided "
         "into two.");
  take.begin = [this] { choose("boundary", "onto", 1.0); };
  DemoStep pull = click(end(&BoundaryPair::b));
  pull.buttons = kFirstLook;
  pull.rest = kLookTime;
  steps.insert(steps.end(), {take, press(kFirstLook), pull, rest(kLookTime, [this] { return isSettled(); })});
}

void RepairDemo::addFilling(std::vector<DemoStep>& steps) {
  for (const bool isFirst : {true, false}) {
    DemoStep go = click([this]() -> std::optional<Vec3> {
      const BoundaryLoop* part = nextPart();
      return part ? std::optional(part->centre) : std::nullopt;
    });
    if (isFirst) {
      go.caption = tr("4 of 5: fill both parts");
      go.detail = tr("The first button shows the patch of a hole, the second fills the hole with it.");
    }
    go.begin = [this, isFirst] {
      if (isFirst) useTool("fillTool");
      lookFrom(m_hole.outward());
    };
    DemoStep seen = rest(kLookTime, [this] {
      const auto* tool = dynamic_cast<const FillHoleTool*>(m_parts.tools.runner().tool());
      return tool && tool->state() == FillHoleTool::State::Ready &&
             m_hole.holds(m_document->document.mesh(), *tool->loop());
    });
    steps.insert(steps.end(),
                 {go, press(kFirstLook), seen, press(kSecond), rest(kLookTime, [this] { return isSettled(); })});
  }
}

void RepairDemo::addSculpting(std::vector<DemoStep>& steps) {
  DemoStep refine = rest(kLookTime, [this] {
    const auto* tool = dynamic_cast<const SculptTool*>(m_parts.tools.runner().tool());
    return tool && tool->levels().finest() > 0 && isSettled();
  });
  refine.caption = tr("5 of 5: sculpt the patch");
  refine.detail = tr("It is subdivided and dragged at its coarse level; the fine level follows as if on a spring.");
  refine.begin = [this] {
    useTool("sculptTool");
    const double size = m_hole.region().diagonal().norm();
    choose("sculpt", "brush", 0.0);
    choose("sculpt", "radius", kBrush * size);
    lookFrom(m_hole.outward() + m_parts.viewport.camera().right());
    perform("subdivide");
  };
  DemoStep level = rest(kLookTime);
  level.begin = [this] { perform("coarser"); };
  steps.insert(steps.end(), {refine, level});
  const auto pulled = [this](double out) {
    return [this, out]() -> std::optional<Vec3> {
      std::optional<Vec3> corner = cornerNear(middleOf(m_document->newest));
      if (corner) *corner += out * m_hole.region().diagonal().norm() * m_hole.outward().normalized();
      return corner;
    };
  };
  DemoStep pull = click(pulled(kPull));
  pull.buttons = kFirstLook;
  pull.rest = kLookTime;
  steps.insert(steps.end(),
               {click(pulled(0.0)), press(kFirstLook), pull, rest(kLookTime, [this] { return isSettled(); })});

  DemoStep whole = rest(kLookTime);
  whole.caption = refine.caption;
  whole.detail = tr("The seam of both patches is smoothed as a part of the whole surface.");
  whole.begin = [this] {
    perform("whole");
    choose("sculpt", "brush", 1.0);
  };
  // To and fro over the seam, from the middle of one patch to as far on the other side.
  const auto side = [this](bool isFar) {
    return [this, isFar]() -> std::optional<Vec3> {
      const Vec3 middle = middleOf(m_document->newest);
      return cornerNear(isFar ? Vec3(2.0 * m_hole.region().center() - middle) : middle);
    };
  };
  steps.insert(steps.end(), {whole, click(side(false)), press(kFirstLook)});
  for (int i = 0; i < kStrokes; ++i) {
    DemoStep stroke = click(side(i % 2 == 0));
    stroke.buttons = kFirstLook;
    steps.push_back(stroke);
  }
  steps.push_back(rest(2.0 * kLookTime, [this] { return isSettled(); }));
}

// Returns the corner of the surface nearest to a position.
std::optional<Vec3> RepairDemo::cornerNear(const Vec3& position) const {
  const HalfEdgeMesh& mesh = m_document->document.mesh();
  std::optional<Vec3> nearest;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (const Vec3& p : mesh.points(f)) {
      if (!nearest || (p - position).norm() < (*nearest - position).norm()) nearest = p;
    }
  }
  return nearest;
}

Vec3 RepairDemo::middleOf(const FaceSelection& faces) const {
  Box box;
  faces.forEach([&](Face f) {
    for (const Vec3& p : m_document->document.mesh().points(f)) box.extend(p);
  });
  return box.center();
}

bool RepairDemo::isSettled() const {
  return m_parts.jobs.isIdle() && !m_jobs.isWorking() && m_parts.viewport.isPickingReady();
}

bool RepairDemo::takeHole() {
  m_document->cardDismissed = false;
  return m_hole.take(m_document->document.mesh(), m_document->defectList);
}

const BoundaryLoop* RepairDemo::nextPart() const {
  return m_hole.nextPart(m_document->document.mesh(), m_document->defectList);
}

std::optional<Vec3> RepairDemo::firstPoint(const BoundaryLoop* loop) const {
  if (!loop) return std::nullopt;
  const HalfEdgeMesh& mesh = m_document->document.mesh();
  const Vec3 towards = m_parts.viewport.camera().towardsViewer();
  const auto nearest = std::max_element(loop->halfEdges.begin(), loop->halfEdges.end(), [&](HalfEdge a, HalfEdge b) {
    return mesh.position(mesh.from(a)).dot(towards) < mesh.position(mesh.from(b)).dot(towards);
  });
  return mesh.position(mesh.from(*nearest));
}

void RepairDemo::lookFrom(const Vec3& direction) {
  const Vec3 half = kNear * 0.5 * m_hole.region().sizes();
  m_parts.viewport.flyTo(Box(m_hole.region().center() - half, m_hole.region().center() + half), direction);
}

void RepairDemo::useTool(const char* action) {
  if (auto* const found = m_parts.window->findChild<QAction*>(QLatin1String(action))) found->trigger();
}

void RepairDemo::perform(const char* action) {
  m_parts.tools.runner().perform(action);
}

void RepairDemo::choose(const char* tool, const char* setting, const PropertyValue& value) {
  if (const Tool* running = m_parts.tools.runner().tool(); running && running->id() == tool) {
    for (const Property& property : running->settings()) {
      if (property.id == setting) m_changed.push_back({tool, setting, property.value});
    }
  }
  m_parts.tools.choose(tool, setting, value);
}

// Returns true if the tool in use shows this among its settings.
bool RepairDemo::shows(const char* tool, const char* setting) const {
  const Tool* running = m_parts.tools.runner().tool();
  if (!running || running->id() != tool) return false;
  const std::vector<Property> settings = running->settings();
  return std::any_of(settings.begin(), settings.end(), [&](const Property& each) { return each.id == setting; });
}

}  // namespace handwheel
