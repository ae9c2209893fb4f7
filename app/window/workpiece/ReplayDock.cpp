// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/ReplayDock.h"

#include "controls/ScrolledPanel.h"
#include "document/exercise/ExerciseSnapshot.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/lathe/LatheJson.h"
#include "panels/DockTitle.h"
#include "panels/MessageBar.h"
#include "panels/time/TimeLinePanel.h"
#include "text/ErrorText.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/FileDialogs.h"
#include "window/tools/ToolHost.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

QString toolText(const TurningPass& pass) {
  if (!pass.tool && pass.thread)
    return ReplayDock::tr("threading tool, R %1 mm").arg(QLocale().toString(pass.noseRadius));
  if (!pass.tool) return ReplayDock::tr("round tool, R %1 mm").arg(QLocale().toString(pass.noseRadius));
  return QCoreApplication::translate("LatheTool", titleOf(pass.tool->kind)) + QLatin1Char(' ') +
         QString::fromStdString(pass.tool->designation);
}

}  // namespace

ReplayDock::ReplayDock(const WindowContext& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_toggle(tr("&Replay"), this), m_views(JobRunner::Policy::Queue, parts.pool) {
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
  m_compare = new QPushButton(page);
  m_compare->setObjectName(QStringLiteral("replayCompare"));
  auto* const row = new QHBoxLayout;
  row->addWidget(m_text, 1);
  row->addWidget(m_compare);
  auto* const column = new QVBoxLayout(page);
  column->addLayout(row);
  column->addWidget(m_line, 1);
  m_dock->setWidget(new ScrolledPanel(page, ScrolledPanel::Directions::Both, m_dock));
  window->addDockWidget(Qt::BottomDockWidgetArea, m_dock);
  if (auto* lathe = window->findChild<QDockWidget*>(QStringLiteral("latheDock")))
    window->tabifyDockWidget(lathe, m_dock);
  connect(m_line, &TimeLinePanel::timeChanged, this, &ReplayDock::show);
  connect(m_compare, &QPushButton::clicked, this, [this] { m_other ? dropOther() : askForOther(); });
  connect(m_dock, &QDockWidget::visibilityChanged, this, [this] {
    m_toggle.setChecked(!m_dock->isHidden());
    if (m_isOpen && m_document && m_dock->isHidden()) open(false);
  });
}

void ReplayDock::setDocument(DocumentTab* document) {
  open(false);
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  m_played.reset();
  m_other.reset();
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

namespace {

QString crashText(const LatheCollision& crash) {
  const auto words = [](const char* text) { return QCoreApplication::translate("LathePart", text); };
  if (crash.cause != CrashCause::Contact) return words(sentenceOf(crash.cause));
  return ReplayDock::tr("Crash: %1, %2").arg(words(titleOf(crash.moving)), words(titleOf(crash.struck)));
}

// Adds the curves of the tool position and the distance travelled.
void addPath(TimeLineRecording& recording, const PassesReplay& replay) {
  TimeLineCurve across{ReplayDock::tr("Distance from the axis"), ReplayDock::tr("mm"), {}};
  TimeLineCurve along{ReplayDock::tr("Z"), ReplayDock::tr("mm"), {}};
  double distance = 0.0;
  for (std::size_t i = 0; i < replay.passes().size(); ++i) {
    const TurningPass& pass = *replay.passes()[i];
    recording.markers.push_back({replay.begin(i), ReplayDock::tr("Pass %1: %2").arg(i + 1).arg(toolText(pass)),
                                 TimeLineMarker::Severity::Note});
    for (std::size_t k = 0; k < std::min(pass.path.size(), pass.times.size()); ++k) {
      const double seconds = replay.begin(i) + pass.times[k];
      if (k > 0) distance += (pass.path[k] - pass.path[k - 1]).norm();
      across.points.emplace_back(seconds, pass.path[k].x());
      along.points.emplace_back(seconds, pass.path[k].y());
      recording.distance.emplace_back(seconds, distance);
    }
  }
  recording.curves = {std::move(across), std::move(along)};
}

TimeLineRecording recordingOf(const QString& name, const ReplayCurves& track) {
  constexpr std::size_t kMostPoints = 2000;
  TimeLineRecording recording;
  recording.name = name;
  recording.duration = track.replay->duration();
  TimeLineCurve force{ReplayDock::tr("Resultant force"), ReplayDock::tr("N"), {}};
  TimeLineCurve power{ReplayDock::tr("Motor power"), ReplayDock::tr("kW"), {}};
  for (const CutLoad& load : track.loads) {
    force.points.emplace_back(load.time, load.force);
    power.points.emplace_back(load.time, load.power);
  }
  addPath(recording, *track.replay);
  recording.curves.insert(recording.curves.begin(), {std::move(force), std::move(power)});
  if (track.deviation) {
    TimeLineCurve left{ReplayDock::tr("Material left over the target"), ReplayDock::tr("mm"), {}};
    TimeLineCurve deep{ReplayDock::tr("Cut too deep"), ReplayDock::tr("mm"), {}};
    for (const auto& [seconds, mm] : track.deviation->left) left.points.emplace_back(seconds, mm);
    for (const auto& [seconds, mm] : track.deviation->deep) deep.points.emplace_back(seconds, mm);
    recording.curves.push_back(std::move(left));
    recording.curves.push_back(std::move(deep));
  }
  for (TimeLineCurve& curve : recording.curves) curve.points = thinnedCurve(curve.points, kMostPoints);
  for (const ReplayCurves::Crash& crash : track.crashes)
    recording.markers.push_back({crash.seconds, crashText(crash.collision), TimeLineMarker::Severity::Error});
  std::stable_sort(recording.markers.begin(), recording.markers.end(),
                   [](const auto& a, const auto& b) { return a.time < b.time; });
  return recording;
}

}  // namespace

// Makes all curves here: there are as many points as the hand made.
ReplayDock::PlayedPointer ReplayDock::playedOf(const QString& name, const WorkpieceSnapshot& work, Progress progress) {
  auto track = work.part ? replayCurves(work, progress) : std::nullopt;
  if (!track) return nullptr;
  TimeLineRecording recording = recordingOf(name, *track);
  return std::make_shared<const Played>(Played{work, std::make_shared<const ReplayCurves>(std::move(*track)),
                                               std::move(recording),
                                               std::make_shared<PlayedPart>(work.chord, work.stock.position)});
}

void ReplayDock::prepare() {
  const WorkpieceSnapshot& work = workpiece().workpiece();
  const auto part = work.part;
  emit partShown(nullptr);
  m_played.reset();
  m_other.reset();
  m_replayed = part;
  m_line->setRecordings({});
  m_line->setEnabled(false);
  m_compare->setEnabled(false);
  m_compare->setText(tr("&Compare with…"));
  m_text->setText(part ? QString() : tr("Nothing has been cut yet. Recorded passes can be played here."));
  if (!part) return;
  Job job;
  job.name = tr("Preparing the replay");
  job.document = &m_document->document;
  job.owner = this;
  job.lane = Job::Lane::Looking;
  job.isUnasked = true;
  job.work = [this, work, name = m_document->document.name()](Progress progress) -> Job::Finish {
    const PlayedPointer played = playedOf(name, work, progress);
    return [this, played] {
      if (played && m_isOpen && m_document && workpiece().workpiece().part == played->work.part) begin(played);
    };
  };
  m_parts.jobs.start(std::move(job));
}

void ReplayDock::begin(PlayedPointer played) {
  m_played = std::move(played);
  LatheSetup setup = latheOf(m_played->work);
  LatheTools tools = shippedLatheTools();
  setup.stations.clear();
  for (const auto& pass : m_played->track->replay->passes()) {
    if (!pass->tool) continue;
    std::erase_if(tools, [&](const auto& each) { return each->id == pass->tool->id; });
    tools.push_back(pass->tool);
    if (std::none_of(setup.stations.begin(), setup.stations.end(),
                     [&](const LatheSlot& slot) { return slot.tool == pass->tool->id; }))
      setup.stations.push_back({pass->tool->id});
  }
  const StockCylinder& stock = m_played->work.stock;
  m_lathe = std::make_unique<LatheDisplay>(setup, tools, 0.5 * stock.diameter, stock.position);
  m_line->setEnabled(true);
  m_compare->setEnabled(true);
  showRecordings();
}

void ReplayDock::askForOther() {
  auto* dialog = new QFileDialog(m_parts.window, tr("Compare with"), folderFor(m_document->document),
                                 tr("Workpieces (%1)").arg(QStringLiteral("*.handwheel")));
  dialog->setObjectName(QStringLiteral("replayCompareDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &ReplayDock::compareWith);
  dialog->open();
}

void ReplayDock::compareWith(const QString& path) {
  if (!m_played) return;
  const QString name = QFileInfo(path).fileName();
  Job job;
  job.name = tr("Preparing the replay");
  job.document = &m_document->document;
  job.owner = this;
  job.lane = Job::Lane::Looking;
  const auto failed = [this, name](const QString& reason) {
    emit message({Message::Weight::Error, tr("%1 cannot be compared").arg(name), reason});
  };
  job.work = [this, path, name, failed, &kinds = m_parts.kinds, first = m_replayed](Progress progress) -> Job::Finish {
    const Result<OpenedFile> opened = kinds.open(QFile::encodeName(path).toStdString(), {}, progress.part(0.0, 0.3));
    if (!opened) return [failed, reason = errorSentence(opened.error())] { failed(reason); };
    // A submission contains the work.
    const auto* const handedIn = dynamic_cast<const ExerciseSnapshot*>(opened->content.get());
    const Snapshot* const content = handedIn ? handedIn->work.get() : opened->content.get();
    const auto* const work = dynamic_cast<const WorkpieceSnapshot*>(content);
    if (!work || !work->part) return [failed] { failed(tr("It is not a workpiece that was cut.")); };
    const PlayedPointer other = playedOf(name, *work, progress.part(0.3, 1.0));
    return [this, other, first] {
      if (other && m_isOpen && m_played && m_replayed == first) beginOther(other);
    };
  };
  m_parts.jobs.start(std::move(job));
}

void ReplayDock::beginOther(PlayedPointer other) {
  m_other = std::move(other);
  m_compare->setText(tr("&Leave %1").arg(m_other->recording.name));
  showRecordings();
}

void ReplayDock::dropOther() {
  m_other.reset();
  m_compare->setText(tr("&Compare with…"));
  showRecordings();
}

// Shows the view from the end, where the tool works.
void ReplayDock::showRecordings() {
  std::vector<TimeLineRecording> recordings{m_played->recording};
  if (m_other) recordings.push_back(m_other->recording);
  m_line->setRecordings(std::move(recordings));
  const double end = m_played->track->replay->duration();
  m_line->setTime(end);
  show(end);
}

// A worker makes the part, which takes longer than a frame where the recording is long: then the next time that is
// shown is the one that is wanted by then.
void ReplayDock::show(double seconds) {
  if (!m_played || !m_isOpen) return;
  m_wanted = seconds;
  if (m_isShowing) return;
  m_isShowing = true;
  Job job;
  job.name = tr("Showing the replay");
  job.failed = [this](const Error&) { m_isShowing = false; };
  job.work = [this, seconds, first = m_played, other = m_other,
              ofOther = m_other ? m_line->timeOf(1) : 0.0](Progress) -> Job::Finish {
    const PassesReplay::Moment moment = first->track->replay->at(seconds);
    auto model = std::make_shared<DisplayModel>(first->part->at(moment.profile, moment.threads));
    if (other) {
      const StockCylinder &stock = first->work.stock, &otherStock = other->work.stock;
      // Below the first, as seen by the operator: up is against y.
      const double aside = 0.75 * (stock.diameter + otherStock.diameter) + latheOf(first->work).chuck.diameter / 2;
      const PassesReplay::Moment beside = other->track->replay->at(ofOther);
      for (DisplayPart& part : other->part->at(beside.profile, beside.threads).parts) {
        part.name = "other." + part.name;
        part.group = "other";
        part.pose.translation() += Vec3(0.0, aside, stock.position - otherStock.position);
        model->parts.push_back(std::move(part));
      }
    }
    return [this, seconds, first, other, moment, model] {
      m_isShowing = false;
      if (!m_played || !m_isOpen) return;
      const bool isOfBoth = m_played == first && m_other == other;
      if (isOfBoth) shown(model, moment);
      if (!isOfBoth || m_wanted != seconds) show(m_wanted);
    };
  };
  m_views.start(std::move(job));
}

// Shows the part with the tool at its position at that time.
void ReplayDock::shown(const std::shared_ptr<DisplayModel>& model, const PassesReplay::Moment& moment) {
  if (moment.pass) {
    const double zero = shownZero(m_played->work, m_document && workpiece().file().assigned);
    m_text->setText(tr("Pass %1 of %2: %3, at R %4 mm, Z %5 mm")
                        .arg(moment.number + 1)
                        .arg(m_played->track->replay->passes().size())
                        .arg(toolText(*moment.pass), QLocale().toString(moment.position.x(), 'f', 2),
                             QLocale().toString(moment.position.y() - zero, 'f', 2)));
    const LatheTool* const tool = moment.pass->tool.get();
    const bool isDrill = tool && tool->kind == LatheToolKind::Drill;
    const std::vector<DisplayPart> parts =
        m_lathe->parts(0.0, moment.position, isDrill ? nullptr : tool,
                       isDrill ? moment.position.y() : latheOf(m_played->work).tailstock.position);
    model->parts.insert(model->parts.end(), parts.begin(), parts.end());
  }
  emit partShown(model);
}

}  // namespace handwheel
