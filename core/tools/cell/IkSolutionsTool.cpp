// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/IkSolutionsTool.h"

#include "base/Tolerance.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellProperties.h"
#include "tools/ToolProperty.h"
#include "tools/cell/path/IkSolutionText.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

constexpr ToolKey kIkSolutionsKeys[] = {
    {"next", "PgDown", QT_TRANSLATE_NOOP("Tool", "next way")},
    {"previous", "PgUp", QT_TRANSLATE_NOOP("Tool", "previous way")},
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "move the robot there")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "back to the current pose of the robot")},
};

constexpr double kPoseAxis = 60.0;  // mm

}  // namespace

IkSolutionsTool::IkSolutionsTool(RobotCellDocument& document, IkSolutionsServices services)
    : m_document(document), m_services(std::move(services)) {
  documentChanged();
}

std::span<const ToolKey> IkSolutionsTool::keys() {
  return kIkSolutionsKeys;
}

void IkSolutionsTool::documentChanged() {
  m_pose = toolPose(m_document.robot(), *m_document.plans(), m_document.joints());
  forgetSolutions();
}

void IkSolutionsTool::forgetSolutions() {
  m_chosen = 0;
  m_scene.reset();
  m_solutions.clear();
}

// The cell may be prepared, or be another one, at any time.
const std::vector<CellIkSolution>& IkSolutionsTool::solutions() const {
  const auto scene = m_services.scene();
  if (scene == m_scene) return m_solutions;
  m_scene = scene;
  m_solutions = scene ? ikSolutionsTo(*scene, *m_document.plans(), m_pose, scene->planned(m_document.joints()))
                      : std::vector<CellIkSolution>();
  return m_solutions;
}

const CellIkSolution* IkSolutionsTool::solution() const {
  return m_chosen < solutions().size() ? &m_solutions[m_chosen] : nullptr;
}

bool IkSolutionsTool::isThere() const {
  const CellIkSolution* const chosen = solution();
  if (!chosen) return true;
  return (chosen->arm.values - m_scene->planned(m_document.joints())).cwiseAbs().maxCoeff() < tolerance::kStillJoint;
}

ToolReply IkSolutionsTool::pointer(const PointerEvent& event) {
  if (event.kind == PointerEvent::Kind::Hover || event.kind == PointerEvent::Kind::Leave) return ToolReply::Used;
  if (!event.device || event.kind != PointerEvent::Kind::Press) return ToolReply::Ignored;  // the camera's
  return perform(event.button == PointerButton::Second ? "commit" : "next");
}

ToolReply IkSolutionsTool::choose(std::size_t index) {
  if (solutions().empty()) return ToolReply::Ignored;
  m_chosen = index % m_solutions.size();
  return ToolReply::Used;
}

ToolReply IkSolutionsTool::commit() {
  const CellIkSolution* const chosen = solution();
  if (!chosen || !chosen->isWithinLimits() || isThere()) return ToolReply::Ignored;
  auto edit = m_document.jointEdit(m_scene->whole(chosen->arm.values));
  if (!edit) return ToolReply::Ignored;
  const Pose now = toolPose(m_document.robot(), *m_document.plans(), m_document.joints());
  const QString text = now.isApprox(m_pose, 1e-9)
                           ? QCoreApplication::translate("IkSolutionsTool", "Change the configuration of the arm")
                           : QCoreApplication::translate("IkSolutionsTool", "Move the tool");
  m_document.commit(text, std::move(edit));
  return ToolReply::Used;
}

ToolReply IkSolutionsTool::perform(std::string_view action) {
  if (action == "next") return choose(m_chosen + 1);
  if (action == "previous") return choose(m_chosen + std::max<std::size_t>(1, solutions().size()) - 1);
  if (action == "commit") return commit();
  if (action != "revert") return ToolReply::Ignored;
  if (isThere() && solution()) return ToolReply::Finished;
  const bool wasElsewhere =
      !m_pose.isApprox(toolPose(m_document.robot(), *m_document.plans(), m_document.joints()), 1e-9);
  const bool wasOther = m_chosen > 0;
  documentChanged();
  return wasElsewhere || wasOther ? ToolReply::Used : ToolReply::Finished;
}

std::vector<ToolAction> IkSolutionsTool::actions() const {
  const bool isAny = solutions().size() > 1;
  const CellIkSolution* const chosen = solution();
  const bool isPossible = chosen && chosen->isWithinLimits() && !isThere();
  std::vector<ToolAction> all{
      actionOf(kIkSolutionsKeys, "next", isAny), actionOf(kIkSolutionsKeys, "previous", isAny),
      actionOf(kIkSolutionsKeys, "commit", isPossible),
      actionOf(kIkSolutionsKeys, "revert", true, isThere() && chosen ? QT_TRANSLATE_NOOP("Tool", "done") : nullptr)};
  if (!isPossible) {
    all[2].reason = !m_scene  ? QT_TRANSLATE_NOOP("Tool", "the cell is being prepared")
                    : !chosen ? QT_TRANSLATE_NOOP("Tool", "this pose is out of reach")
                    : !chosen->isWithinLimits()
                        ? QT_TRANSLATE_NOOP("Tool", "a joint would be beyond its limits")
                        : QT_TRANSLATE_NOOP("Tool", "the robot is already in this configuration");
  }
  return all;
}

// The robot as it would stand, and the pose that is looked at.
ToolPreview IkSolutionsTool::preview() const {
  ToolPreview preview;
  for (int axis = 0; axis < 3; ++axis)
    preview.lines.push_back({m_pose.translation(), m_pose * Vec3(kPoseAxis * Vec3::Unit(axis))});
  const CellIkSolution* const chosen = solution();
  if (!chosen || isThere()) return preview;
  const JointValues joints = m_scene->whole(chosen->arm.values);
  auto shown = std::make_shared<DisplayModel>(displayOf(m_document.robot(), joints, m_document.bodies()));
  if (m_services.mark) m_services.mark(*shown, joints);
  preview.replaced = std::move(shown);
  return preview;
}

std::vector<Property> IkSolutionsTool::settings() const {
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < solutions().size(); ++i)
    rows.push_back(ikSolutionText(*m_scene, m_solutions[i], i + 1).toStdString());
  const bool isOut = m_scene && rows.empty();
  if (rows.empty()) rows.emplace_back(QT_TRANSLATE_NOOP("Property", "none"));
  std::vector<Property> all{choiceSetting("way", QT_TRANSLATE_NOOP("Property", "Configuration of the arm"),
                                          static_cast<int>(m_chosen), std::move(rows))};
  all.front().continuous = true;
  all.front().group = all.front().label;
  if (isOut) all.front().problem = QT_TRANSLATE_NOOP("Property", "this pose is out of reach");
  for (Property& each : poseProperties("", QT_TRANSLATE_NOOP("Property", "Tool"), m_pose))
    all.push_back(std::move(each));
  return all;
}

void IkSolutionsTool::setSetting(std::string_view id, const PropertyValue& value) {
  const auto* const number = std::get_if<double>(&value);
  if (id == "way" && number && *number >= 0.0) {
    choose(static_cast<std::size_t>(*number));
  } else if (const auto changed = changedPose(m_pose, id, value)) {
    m_pose = *changed;
    forgetSolutions();
  }
}

}  // namespace handwheel
