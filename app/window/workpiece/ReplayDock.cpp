// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/ReplayDock.h"

#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "machining/lathe/LatheJson.h"
#include "panels/DockTitle.h"
#include "panels/time/TimeLinePanel.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/tools/ToolHost.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

QString toolText(const TurningPass& pass) {
  if (!pass.tool) return ReplayDock::tr("round tool, R %1 mm").arg(QLocale().toString(pass.noseRadius));
  return QCoreApplication::translate("LatheTool", titleOf(pass.tool->kind)) + QLatin1Char(' ') +
         QString::fromStdString(pass.tool->designation);
}

}  // namespace

ReplayDock::ReplayDock(const WindowContext& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_toggle(tr("&Replay"), this) {
  handwheel::prepare(m_toggle, "replayDockToggle", "play", tr("Plays the passes that cut the part, on a time line"));
  m_toggle.setCheckable(true);
  connect(&m_toggle, &QAction::triggered, this, &ReplayDock::open);
  connect(&parts.tools, &ToolHost::updated, this, &ReplayDock::followTool);
}

const WorkpieceDocument& ReplayDock::workpiece() const {
  return static_cast<const WorkpieceDocument&>(m_document->document);
}

void ReplayDock::makeDock() {
  auto* const window = qobject_cast<QMainWindow*>(m_parts.window);
  if (m_dock || !window) return;
  m_dock = new QDockWidget(tr("Replay"), window);
  m_dock->setObjectName(QStringLiteral("replayDock"));
  m_dock->setAccessibleName(m_dock->windowTitle());
  m_dock->setTitleBarWidget(new DockTitle(m_dock));
  auto* const page = new QWidget(m_dock);
  m_text = new QLabel(page);
  m_text->setObjectName(QStringLiteral("replayText"));
  m_text->setTextFormat(Qt::PlainText);
  m_line = new TimeLinePanel(page);
  m_line->setObjectName(QStringLiteral("replayTimeLine"));
  auto* const column = new QVBoxLayout(page);
  column->addWidget(m_text);
  column->addWidget(m_line, 1);
  m_dock->setWidget(page);
  window->addDockWidget(Qt::BottomDockWidgetArea, m_dock);
  if (auto* lathe = window->findChild<QDockWidget*>(QStringLiteral("latheDock")))
    window->tabifyDockWidget(lathe, m_dock);
  connect(m_line, &TimeLinePanel::timeChanged, this, &ReplayDock::show);
  connect(m_dock, &QDockWidget::visibilityChanged, this, [this] {
    m_toggle.setChecked(!m_dock->isHidden());
    if (m_isOpen && m_document && m_dock->isHidden()) open(false);
  });
}

void ReplayDock::setDocument(DocumentTab* document) {
  open(false);
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  m_replay.reset();
  m_replayed.reset();
  if (!document) return;
  connect(&document->document, &Document::changed, this, [this] {
    if (m_isOpen && m_replayed != workpiece().workpiece().part) prepare();
  });
}

void ReplayDock::open(bool isOpen) {
  if (isOpen) makeDock();
  m_isOpen = isOpen && m_document && m_dock;
  if (m_dock && m_dock->isHidden() == m_isOpen) m_dock->setVisible(m_isOpen);
  m_toggle.setChecked(m_isOpen);
  if (m_isOpen) {
    m_dock->raise();
    return prepare();
  }
  if (m_line) m_line->setPlaying(false);
  m_parts.jobs.cancelOf(this);
  emit partShown(nullptr);
}

// A tool that begins to work on the part works on the present one.
void ReplayDock::followTool() {
  const Tool* const tool = m_parts.tools.runner().tool();
  const bool isLive = tool && tool->isLive();
  if (!std::exchange(m_wasLive, isLive) && isLive && m_isOpen) open(false);
}

void ReplayDock::prepare() {
  const WorkpieceSnapshot& work = workpiece().workpiece();
  const auto part = work.part;
  emit partShown(nullptr);
  m_replay.reset();
  m_replayed = part;
  m_line->setRecordings({});
  m_line->setEnabled(false);
  m_text->setText(part ? QString() : tr("Nothing was cut yet. What you cut can be played here."));
  if (!part) return;
  const TurnedProfile bar(work.stock, part->profile.spacing());
  Job job;
  job.name = tr("Preparing the replay");
  job.owner = this;
  job.work = [this, bar, part](Progress progress) -> Job::Finish {
    auto made = PassesReplay::make(bar, part->passes, progress);
    auto replay = made ? std::make_shared<const PassesReplay>(std::move(*made)) : nullptr;
    return [this, part, replay] {
      if (replay && m_isOpen && m_document && workpiece().workpiece().part == part) begin(replay);
    };
  };
  m_parts.jobs.start(std::move(job));
}

void ReplayDock::begin(const std::shared_ptr<const PassesReplay>& replay) {
  m_replay = replay;
  const WorkpieceSnapshot& work = workpiece().workpiece();
  LatheSetup setup = latheOf(work);
  LatheTools tools = shippedLatheTools();
  setup.stations.clear();
  for (const auto& pass : replay->passes()) {
    if (!pass->tool) continue;
    std::erase_if(tools, [&](const auto& each) { return each->id == pass->tool->id; });
    tools.push_back(pass->tool);
    if (std::none_of(setup.stations.begin(), setup.stations.end(),
                     [&](const LatheSlot& slot) { return slot.tool == pass->tool->id; }))
      setup.stations.push_back({pass->tool->id});
  }
  m_lathe = std::make_unique<LatheDisplay>(setup, tools, 0.5 * work.stock.diameter, work.stock.position);
  m_line->setEnabled(true);
  m_line->setRecordings({recordingOf(*replay)});
  m_line->setTime(replay->duration());
  show(replay->duration());
}

TimeLineRecording ReplayDock::recordingOf(const PassesReplay& replay) const {
  constexpr std::size_t kMostPoints = 2000;
  TimeLineRecording recording;
  recording.name = m_document->document.name();
  recording.duration = replay.duration();
  TimeLineCurve across{tr("Distance from the axis"), tr("mm"), {}}, along{tr("Z"), tr("mm"), {}};
  for (std::size_t i = 0; i < replay.passes().size(); ++i) {
    const TurningPass& pass = *replay.passes()[i];
    recording.markers.push_back(
        {replay.begin(i), tr("Pass %1: %2").arg(i + 1).arg(toolText(pass)), TimeLineMarker::Severity::Note});
    for (std::size_t k = 0; k < std::min(pass.path.size(), pass.times.size()); ++k) {
      across.points.emplace_back(replay.begin(i) + pass.times[k], pass.path[k].x());
      along.points.emplace_back(replay.begin(i) + pass.times[k], pass.path[k].y());
    }
  }
  for (TimeLineCurve* const curve : {&across, &along}) {
    curve->points = thinnedCurve(curve->points, kMostPoints);
    recording.curves.push_back(std::move(*curve));
  }
  return recording;
}

void ReplayDock::show(double seconds) {
  if (!m_replay || !m_isOpen) return;
  const WorkpieceSnapshot& work = workpiece().workpiece();
  const PassesReplay::Moment moment = m_replay->at(seconds);
  const TurnedSurface surface(moment.profile, work.chord, moment.threads);
  auto model = std::make_shared<DisplayModel>(displayOf(surface, work.stock.position));
  if (moment.pass) {
    m_text->setText(tr("Pass %1 of %2: %3, at R %4 mm, Z %5 mm")
                        .arg(moment.number + 1)
                        .arg(m_replay->passes().size())
                        .arg(toolText(*moment.pass), QLocale().toString(moment.place.x(), 'f', 2),
                             QLocale().toString(moment.place.y(), 'f', 2)));
    const LatheTool* const tool = moment.pass->tool.get();
    const bool isDrill = tool && tool->kind == LatheToolKind::Drill;
    const std::vector<DisplayPart> parts = m_lathe->parts(0.0, moment.place, isDrill ? nullptr : tool,
                                                          isDrill ? moment.place.y() : latheOf(work).tailstock.place);
    model->parts.insert(model->parts.end(), parts.begin(), parts.end());
  }
  emit partShown(model);
}

}  // namespace handwheel
