// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/PathDock.h"

#include "controls/ScrolledPanel.h"
#include "controls/SqueezedPage.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotCellDocument.h"
#include "document/scene/BodyDisplay.h"
#include "panels/DockTitle.h"
#include "panels/time/TimeLinePanel.h"
#include "window/ActionToolTip.h"
#include "window/cell/CellPaths.h"
#include "window/cell/CollisionColour.h"
#include "window/documents/DocumentTab.h"

#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMainWindow>
#include <QVBoxLayout>
#include <utility>

namespace handwheel {

PathDock::PathDock(const WindowContext& parts, CellPaths& paths, QObject* parent)
    : QObject(parent), m_parts(parts), m_paths(paths), m_toggle(tr("Pl&ay the path"), this) {
  handwheel::prepare(m_toggle, "pathDockToggle", "play",
                     tr("Plays the path on a time line, with its clearance and its collisions"));
  m_toggle.setCheckable(true);
  connect(&m_toggle, &QAction::triggered, this, &PathDock::open);
  connect(&paths, &CellPaths::pathChanged, this, [this] {
    if (m_isOpen && m_shown != m_paths.checked()) prepare();
  });
  connect(&paths, &CellPaths::robotSent, this, &PathDock::close);
  connect(&paths, &CellPaths::collisionChosen, this,
          [this](std::size_t number) { goToCollision(m_paths.path()->name, number); });
}

void PathDock::makeDock() {
  auto* const window = qobject_cast<QMainWindow*>(m_parts.window);
  if (m_dock || !window) return;
  m_dock = new QDockWidget(tr("Path"), window);
  m_dock->setObjectName(QStringLiteral("pathDock"));
  m_dock->setAccessibleName(m_dock->windowTitle());
  m_dock->setTitleBarWidget(new DockTitle(m_dock));
  auto* const page = new SqueezedPage(m_dock);
  m_text = new QLabel(page);
  m_text->setObjectName(QStringLiteral("pathText"));
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);  // it names what collides
  m_line = new TimeLinePanel(page);
  m_line->setObjectName(QStringLiteral("pathTimeLine"));
  auto* const column = new QVBoxLayout(page);
  column->addWidget(m_text);
  column->addWidget(m_line, 1);
  m_dock->setWidget(new ScrolledPanel(page, ScrolledPanel::Directions::Both, m_dock));
  window->addDockWidget(Qt::BottomDockWidgetArea, m_dock);
  connect(m_line, &TimeLinePanel::timeChanged, this, &PathDock::show);
  connect(m_dock, &QDockWidget::visibilityChanged, this, [this] {
    m_toggle.setChecked(!m_dock->isHidden());
    if (m_isOpen && m_document && m_dock->isHidden()) open(false);
  });
}

void PathDock::setDocument(DocumentTab* document) {
  open(false);
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  if (document) connect(&document->document, &Document::changed, this, &PathDock::takeChange);
}

JointValues PathDock::standing() const {
  return static_cast<const RobotCellDocument&>(m_document->document).joints();
}

// Users who move the robot, in any panel, see its present joint values; those who work in another frame, the position
// in that frame.
void PathDock::takeChange() {
  if (!m_isOpen) return;
  const JointValues now = standing();
  if (now.size() != m_standing.size() || now != m_standing) return close();
  if (m_countedIn != m_paths.plans().workFrame) show(m_line->time());
}

void PathDock::open(bool isOpen) {
  if (isOpen) makeDock();
  m_isOpen = isOpen && m_document && m_dock;
  if (m_dock && m_dock->isHidden() == m_isOpen) m_dock->setVisible(m_isOpen);
  m_toggle.setChecked(m_isOpen);
  if (m_isOpen) {
    m_standing = standing();
    m_dock->raise();
    return prepare();
  }
  if (m_line) m_line->setPlaying(false);
  m_shown.reset();
  m_timed.reset();
  m_wanted.reset();
  showNothing();
}

void PathDock::showNothing() {
  m_paths.setShownJoints(std::nullopt);
  emit partsShown(nullptr, {});
}

void PathDock::prepare() {
  showNothing();
  m_shown = m_paths.checked();
  m_timed.reset();
  const auto scene = m_paths.scene();
  const bool isKnown = m_shown && scene && m_paths.path();
  const bool isBegun = isKnown && !m_shown->resolved.waypointOf.empty();
  m_line->setEnabled(isBegun);
  if (!isBegun) {
    m_line->setRecordings({});
    m_text->setText(isKnown          ? tr("The straight line to the second place cannot be begun.")
                    : m_paths.path() ? tr("The path is being verified.")
                                     : tr("Select a path in the panel, or plan one, to play it here."));
    return;
  }
  m_timed =
      std::make_unique<TimedPath>(timed(*scene, m_paths.plans(), *m_paths.path(), m_shown->resolved, m_shown->blends));
  m_line->setRecordings({recordingOf(*m_shown)});
  show(0.0);
  goToWanted();
}

void PathDock::goToCollision(const std::string& path, std::size_t number) {
  m_wanted = {path, number};
  m_isOpen ? goToWanted() : open(true);
}

void PathDock::goToWanted() {
  if (!m_wanted || !m_timed || !m_paths.path()) return;
  const auto [path, number] = *std::exchange(m_wanted, std::nullopt);
  const std::vector<PathStretch> all = stretchesOf(*m_shown, *m_paths.scene());
  if (path != m_paths.path()->name || number >= all.size()) return;
  m_line->setPlaying(false);
  m_line->setTime(timeOf(all[number].motion, all[number].deepestAt));
  show(m_line->time());
}

double PathDock::timeOf(std::size_t motion, double share) const {
  // Travel within a motion is not uniform in time: found by bisection.
  double low = m_timed->beginOf(motion), high = m_timed->beginOf(motion + 1);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    const bool isBefore = m_timed->motionAt(middle) <= motion && m_timed->shareAt(middle) < share;
    (isBefore ? low : high) = middle;
  }
  return high;
}

TimeLineRecording PathDock::recordingOf(const CheckedPath& checked) const {
  TimeLineRecording recording;
  recording.name = QString::fromStdString(m_paths.path()->name);
  recording.duration = m_timed->duration();
  TimeLineCurve clearance{tr("Clearance"), tr("mm"), {}}, margin{tr("Margin to the limits"), tr("%"), {}},
      manipulability{tr("Manipulability"), {}, {}};
  for (const PathSample& sample : checked.metrics.samples) {
    const double time = timeOf(sample.motion, sample.share);
    clearance.points.emplace_back(time, sample.clearance);
    margin.points.emplace_back(time, 100.0 * sample.limitMargin);
    manipulability.points.emplace_back(time, sample.manipulability);
  }
  recording.curves = {clearance, manipulability, margin};
  if (const double kept = m_paths.plans().clearanceOf(*m_paths.path()); kept > 0.0)
    recording.curves.push_back(
        {clearance.name, clearance.unit, {{0.0, kept}, {recording.duration, kept}}, tr("Clearance to keep")});
  const auto scene = m_paths.scene();
  for (const PathStretch& each : stretchesOf(checked, *scene)) {
    const auto [link, other] = scene->namesOf(each.deepest);
    recording.markers.push_back({timeOf(each.motion, each.deepestAt),
                                 (each.meets() ? tr("Collision: %1 with %2") : tr("Too near: %1 to %2"))
                                     .arg(QString::fromStdString(link), QString::fromStdString(other)),
                                 each.meets() ? TimeLineMarker::Severity::Error : TimeLineMarker::Severity::Warning});
  }
  return recording;
}

// In the frame that is worked in, as the fields and programs have it, where its pose is known.
QString PathDock::toolText(const CellScene& scene, const ArmValues& values) const {
  const CellPlans& plans = m_paths.plans();
  Vec3 at = (scene.arm.tipPose(values) * plans.tool).translation();
  const JointValues joints = scene.whole(values);
  const Result<Pose> frame = poseOfFrame(plans.workFrame, {plans, scene.bodies, scene.robot->model, joints});
  const bool isInFrame = !plans.workFrame.empty() && frame;
  if (isInFrame) at = frame->inverse(Eigen::Isometry) * at;
  const QLocale locale;
  const QString text =
      tr("X %1  Y %2  Z %3 mm")
          .arg(locale.toString(at.x(), 'f', 1), locale.toString(at.y(), 'f', 1), locale.toString(at.z(), 'f', 1));
  return isInFrame ? tr("%1 in %2").arg(text, QString::fromStdString(plans.workFrame)) : text;
}

void PathDock::show(double seconds) {
  const auto scene = m_paths.scene();
  if (!m_timed || !m_isOpen || !scene) return;
  const ArmValues values = m_timed->valuesAt(seconds);
  auto model = std::make_shared<DisplayModel>(displayOf(*scene->robot, scene->whole(values), scene->bodies));
  const RobotScene::Nearest nearest = scene->scene.tooNear(values, 0.0, 0.0);
  CellCollision colliding{scene, values, {}};
  if (nearest.link != kNone) colliding.pairs = scene->scene.allTooNear(values, 0.0, 0.0);
  markColliding(*model, *scene, colliding.pairs);
  const std::size_t waypoint = m_shown->waypointOf(m_timed->motionAt(seconds));
  QString text =
      tr("To place %1 of %2: %3").arg(waypoint + 1).arg(m_paths.path()->waypoints.size()).arg(toolText(*scene, values));
  if (nearest.link != kNone) {
    const auto [link, other] = scene->namesOf(nearest);
    text += tr("; collision: %1 with %2").arg(QString::fromStdString(link), QString::fromStdString(other));
  }
  m_text->setText(text);
  m_countedIn = m_paths.plans().workFrame;
  m_paths.setShownJoints(scene->whole(values));
  emit partsShown(model, {colliding});
}

}  // namespace handwheel
