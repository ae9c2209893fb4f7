// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellTargets.h"

#include "document/cell/BodyCarriers.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotCellDocument.h"
#include "tools/cell/path/IkSolutionText.h"
#include "viewport/Viewport.h"
#include "viewport/path/PathLayer.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr double kShownAxis = 40.0;       // mm of x and y; z, along which the tool works, is twice as long
constexpr double kSelected = 1.6;         // times as long
constexpr std::size_t kMostShown = 1000;  // targets; frames

// In the plane of x and y; half: of a side.
PathLine squareAbout(const Pose& pose, double half) {
  PathLine square{{}, PathLine::Look::Collision};
  for (const auto& [x, y] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}})
    square.points.emplace_back(pose * Vec3(x, y, 0.0));
  return square;
}

TargetReach reachOf(const CellScene& scene, const CellPlans& plans, const NamedTarget& target,
                    const JointValues& joints) {
  const Result<Pose> pose = poseOfTarget(target, {plans, scene.bodies, scene.robot->model, joints});
  if (!pose) {
    return {false,
            target.body != 0 ? CellTargets::tr("its body was removed") : CellTargets::tr("its frame is on nothing")};
  }
  const std::vector<CellIkSolution> solutions = ikSolutionsTo(scene, plans, *pose, scene.planned(joints));
  const auto count = std::count_if(solutions.begin(), solutions.end(),
                                   [](const CellIkSolution& solution) { return solution.isFree(); });
  const QString remark = solutions.empty() ? CellTargets::tr("out of reach")
                         : count > 0       ? CellTargets::tr("%Ln configuration(s)", nullptr, static_cast<int>(count))
                                           : problemText(scene, solutions.front());
  const BodyPointer body = scene.bodies.withId(target.body);
  if (body) return {count > 0, CellTargets::tr("%1 (on %2)").arg(remark, QString::fromStdString(body->name))};
  if (target.frame.empty()) return {count > 0, remark};
  return {count > 0, CellTargets::tr("%1 (in %2)").arg(remark, QString::fromStdString(target.frame))};
}

}  // namespace

bool CellTargets::Question::operator==(const Question& other) const {
  return scene == other.scene && targets == other.targets && frames == other.frames &&
         tool.matrix() == other.tool.matrix() && clearance == other.clearance && joints.size() == other.joints.size() &&
         joints == other.joints;
}

CellTargets::CellTargets(const WindowContext& parts, CellCollisions& collisions, QObject* parent)
    : QObject(parent), m_parts(parts), m_collisions(collisions), m_layer(std::make_shared<PathLayer>()) {
  parts.viewport.addLayer(m_layer);
  connect(&m_collisions, &CellCollisions::prepared, this, &CellTargets::look);
}

CellTargets::~CellTargets() {
  m_parts.viewport.removeLayer(*m_layer);
}

const RobotCellDocument& CellTargets::cell() const {
  return static_cast<const RobotCellDocument&>(m_document->document);
}

void CellTargets::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_parts.jobs.cancelOf(this);
  m_document = document;
  m_reach.clear();
  m_asked = {};
  if (!document) return m_layer->setLines(nullptr);
  connect(&document->document, &Document::changed, this, &CellTargets::look);
  look();
}

void CellTargets::setVisible(bool isVisible) {
  m_layer->setVisible(isVisible);
}

void CellTargets::setSelected(const std::string& target, const std::string& frame) {
  if (target == m_selectedTarget && frame == m_selectedFrame) return;
  m_selectedTarget = target;
  m_selectedFrame = frame;
  if (m_document) show();
}

CellTargets::Question CellTargets::question() const {
  const CellPlans& plans = *cell().plans();
  Question question{m_collisions.scene(), plans.targets, plans.frames, plans.tool, plans.clearance, {}};
  const auto isBodyCarried = [&](std::uint32_t id) {
    const BodyPointer body = id == 0 ? nullptr : cell().bodies().withId(id);
    return body && carrierOf(*body, cell().robot().model) != kNone;
  };
  const auto isCarried = [&](const NamedTarget& target) {
    const NamedFrame* const frame = target.frame.empty() ? nullptr : plans.frame(target.frame);
    return frame ? !frame->link.empty() || isBodyCarried(frame->body) : isBodyCarried(target.body);
  };
  if (std::any_of(plans.targets.begin(), plans.targets.end(), isCarried)) question.joints = cell().joints();
  return question;
}

// Asks anew, unless all is as it was.
void CellTargets::look() {
  if (!m_document) return;
  show();
  Question asked = question();
  if (asked == m_asked) return;
  m_parts.jobs.cancelOf(this);
  m_asked = asked;
  m_reach.clear();
  emit reachChanged();
  if (!asked.scene || asked.targets.empty()) return;
  Job job;
  job.name = tr("Searching configurations for the targets");
  job.document = &m_document->document;
  job.owner = this;
  job.lane = Job::Lane::Looking;
  job.isUnasked = true;
  job.work = [this, asked, joints = cell().joints()](Progress progress) -> Job::Finish {
    CellPlans plans;
    plans.frames = asked.frames;
    plans.tool = asked.tool;
    plans.clearance = asked.clearance;
    std::map<std::string, TargetReach> reach;
    for (const NamedTarget& target : asked.targets) {
      if (progress.cancelled()) break;
      reach[target.name] = reachOf(*asked.scene, plans, target, joints);
    }
    return [this, asked, reach = std::move(reach)]() mutable {
      if (!m_document || !(asked == m_asked)) return;
      m_reach = std::move(reach);
      show();
      emit reachChanged();
    };
  };
  m_parts.jobs.start(std::move(job));
}

// Those that are not reached have a square about them, in the colour of collisions.
void CellTargets::show() {
  auto lines = std::make_shared<std::vector<PathLine>>();
  const CellPlans& plans = *cell().plans();
  for (std::size_t i = 0; i < std::min(plans.targets.size(), kMostShown); ++i) {
    const NamedTarget& target = plans.targets[i];
    const Result<Pose> pose = poseOfTarget(target, cell().placement());
    if (!pose) continue;
    const auto known = m_reach.find(target.name);
    const bool isReached = known == m_reach.end() || known->second.isFree;
    const double length = target.name == m_selectedTarget ? kSelected * kShownAxis : kShownAxis;
    const std::vector<PathLine> axes = axisLines(*pose, {length, length, 2.0 * length});
    lines->insert(lines->end(), axes.begin(), axes.end());
    if (!isReached) lines->push_back(squareAbout(*pose, 0.5 * length));
  }
  for (std::size_t i = 0; i < std::min(plans.frames.size(), kMostShown); ++i) {
    const Result<Pose> pose = poseOfFrame(plans.frames[i], cell().placement());
    if (!pose) continue;
    const double length = plans.frames[i].name == m_selectedFrame ? kSelected * kShownFrameAxis : kShownFrameAxis;
    const std::vector<PathLine> axes = axisLines(*pose, Vec3::Constant(length));
    lines->insert(lines->end(), axes.begin(), axes.end());
  }
  // Those of one look after the other are drawn at once.
  std::ranges::stable_sort(*lines, {}, &PathLine::look);
  m_layer->setLines(lines->empty() ? nullptr : lines);
}

}  // namespace handwheel
