// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Running a program, cutting the work with it, and looking at its lines one by one.
#include "controls/QuantityText.h"
#include "controls/program/ProgramEditor.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/exercise/AssignedTask.h"
#include "document/workpiece/exercise/TurningMeasurements.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/TurningFidelity.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramCheck.h"
#include "machining/program/ProgramErrors.h"
#include "panels/MessageBar.h"
#include "viewport/Viewport.h"
#include "viewport/camera/CameraNavigation.h"
#include "window/OfferedAction.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/workpiece/program/ProgramPlayer.h"
#include "window/workpiece/program/ProgramSession.h"
#include "window/workpiece/program/ToolPathLines.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

bool isOfProgram(const Error& error) {
  return error.code == ProgramError::Refused || error.code == ProgramError::Alarm ||
         error.code == ProgramError::Endless || error.code == ProgramError::TooManyMoves;
}

// The move of a collision: the first of its line that ends there.
std::size_t moveOf(const ProgramCollision& collision, const ToolPath& path) {
  const auto found = std::find_if(path.moves.begin(), path.moves.end(), [&](const ToolMove& move) {
    return move.line == collision.line && move.to == collision.at;
  });
  return static_cast<std::size_t>(found - path.moves.begin());
}

// Returns true if a program does the same to both.
bool isSameWork(const WorkpieceSnapshot& a, const WorkpieceSnapshot& b) {
  return a.part == b.part && a.chord == b.chord && a.stock == b.stock && a.programPost == b.programPost &&
         programZero(a) == programZero(b) && latheOf(a).chuck == latheOf(b).chuck &&
         latheOf(a).tailstock == latheOf(b).tailstock;
}

// Returns the violated limits of the lathe of an exercise, judged as by the marks.
std::vector<ProgramFinding> limitFindings(const TurningTask& task, WorkpieceSnapshot work, const ProgramTrial& trial,
                                          Progress progress) {
  std::vector<ProgramFinding> findings;
  const auto before = std::exchange(work.part, trial.part());
  const auto peaks = work.part ? peakLoads(task, work, before.get(), progress) : std::nullopt;
  if (!peaks) return findings;
  const auto add = [&](double value, double limit, const QString& text) {
    const QLocale locale;
    if (value > limit)
      findings.push_back({ProgramFinding::Weight::Error, 0, 0,
                          text.arg(locale.toString(value, 'g', 3), locale.toString(limit, 'g', 3)), std::nullopt});
  };
  add(peaks->first, task.forceLimit,
      ProgramSession::tr("resultant force: up to %1 N, where the lathe of the exercise allows %2 N. It is in the "
                         "report of the exercise."));
  add(peaks->second, task.powerLimit,
      ProgramSession::tr(
          "motor power: up to %1 kW, where the lathe of the exercise has %2 kW. It is in the report of the exercise."));
  return findings;
}

// Returns a text with the position as %1 and %2.
QString collisionText(const ProgramCollision& collision, const ToolPath& path) {
  const auto title = [](LathePart part) { return QCoreApplication::translate("LathePart", titleOf(part)); };
  switch (collision.kind) {
    case ProgramCollision::Kind::Contact:
      return ProgramSession::tr("collision: %3 meets %4, on the way to ⌀ %1, Z %2.")
          .arg(QStringLiteral("%1"), QStringLiteral("%2"), title(collision.moving), title(collision.struck));
    case ProgramCollision::Kind::Chuck:
      return ProgramSession::tr("collision: the tip is beyond the face of the chuck, at ⌀ %1, Z %2.");
    case ProgramCollision::Kind::RapidInMaterial:
      return ProgramSession::tr("collision: a rapid move through material, to ⌀ %1, Z %2.");
    case ProgramCollision::Kind::SpindleAtRest:
      break;
  }
  if (isStoppedByChange(path, collision.line))
    return ProgramSession::tr(
        "collision: a feed into material with the spindle at rest, which M6 has stopped, to ⌀ %1, Z %2. Write M3 or "
        "M4 after M6.");
  return ProgramSession::tr("collision: a feed into material with the spindle at rest, to ⌀ %1, Z %2.");
}

}  // namespace

void ProgramSession::forgetRun() {
  if (!m_trial) return;
  m_trial.reset();
  m_picture = {};
  m_panel->player().setDuration(0.0);
  m_panel->editor().setCurrentLine(0);
  m_panel->setCuttable(false, tr("Run the program first."));
  m_panel->setSummary({});
  m_panel->setFindings({});
  emit pictureChanged();
}

// Results of runs on another part, or in another chuck, are dropped, and such runs are cancelled.
void ProgramSession::documentChanged() {
  const WorkpieceSnapshot& now = workpiece().workpiece();
  handwheel::offer(m_fromPasses, now.part != nullptr, tr("Nothing was cut yet."));
  handwheel::offer(m_cycles, now.target != nullptr, tr("There is no target."));
  takeStoredTools();
  m_panel->setPost(now.programPost);
  if (isSameWork(m_start, now)) return;
  m_runs.cancelOf(&m_start);
  forgetRun();
}

bool ProgramSession::isToBeDoneByHand() const {
  const auto task = assignedTask(m_document.document.file().assigned);
  return task && !task->areProgramsAllowed;
}

// The first tool in the teacher's list that turns the outside counts. A tool without a body is only a name, and assumed
// to do so.
std::optional<double> ProgramSession::noseOfExercise() const {
  const auto task = assignedTask(m_document.document.file().assigned);
  if (!task) return std::nullopt;
  const auto turns = [tools = shippedLatheTools()](const AllowedTool& tool) {
    if (tool.noseRadius < TurningPass::kLeastNose || tool.noseRadius > TurningPass::kLargestNose) return false;
    const std::shared_ptr<const LatheTool> body = toolNamed(tools, tool.tool);
    return !body || body->kind == LatheToolKind::RightTurning || body->kind == LatheToolKind::LeftTurning;
  };
  const auto found = std::find_if(task->tools.begin(), task->tools.end(), turns);
  if (found == task->tools.end()) return std::nullopt;
  return found->noseRadius;
}

bool ProgramSession::isRefused() {
  if (!m_isByHand) return false;
  m_panel->setSummary(
      tr("This exercise is to be done by hand: it does not allow programs to be made, run, or to cut."));
  return true;
}

void ProgramSession::run() {
  forgetRun();
  if (isRefused()) return;
  m_pause.stop();
  m_checks.cancelAll();
  m_start = workpiece().workpiece();
  const std::string text = m_panel->editor().toPlainText().toStdString();
  const double spacing = m_parts.fidelity.values().of(turnSpacingSetting());
  Job job;
  job.name = tr("Running the program");
  job.owner = &m_start;
  job.failed = [this](const Error& error) {
    fail(tr("The program could not be run"), error);
    if (m_panel) m_panel->setSummary(error.code == ErrorCode::Cancelled ? tr("The run was cancelled.") : QString());
  };
  job.work = [this, text, spacing, start = m_start, setup = setup(),
              task = assignedTask(m_document.document.file().assigned),
              failed = job.failed](Progress progress) -> Job::Finish {
    auto trial = ProgramTrial::run(start, text, setup, spacing, progress.part(0.0, 0.9));
    if (!trial && isOfProgram(trial.error()))
      return [this, problems = programProblems(text, setup, progress.part(0.95, 1.0))] { checked(problems, true); };
    if (!trial) return [failed, error = trial.error()] { failed(error); };
    const double dash = 0.02 * std::max(start.stock.diameter, start.stock.length);
    const PathLayer::Lines lines = toolPathLines(trial.value()->path(), programZero(start), dash);
    std::vector<ProgramFinding> limits;
    if (task) limits = limitFindings(*task, start, *trial.value(), progress.part(0.9, 1.0));
    return [this, made = trial.value(), lines, limits] { ran(made, lines, limits); };
  };
  m_runs.start(std::move(job));
}

void ProgramSession::ran(ProgramTrial::Pointer trial, PathLayer::Lines lines,
                         const std::vector<ProgramFinding>& limits) {
  m_trial = std::move(trial);
  std::vector<ProgramFinding> findings = findingsOf(*m_trial);
  findings.insert(findings.end(), limits.begin(), limits.end());
  m_panel->setFindings(std::move(findings));
  m_panel->setSummary(summaryOf(*m_trial));
  m_panel->setCuttable(isCuttable(), cuttingTip());
  m_panel->player().setDuration(m_trial->steps().duration());
  m_picture.lines = std::move(lines);
  m_shown = {};
  m_played = std::make_shared<PlayedPart>(m_start.chord, m_start.stock.position);
  goTo(m_trial->steps().end());
}

std::vector<ProgramFinding> ProgramSession::findingsOf(const ProgramTrial& trial) const {
  std::vector<ProgramFinding> findings;
  const LengthUnit unit = m_document.document.displayUnit();
  for (const ProgramCollision& each : trial.collisions()) {
    const auto length = [unit](double mm) {
      return quantityText(std::round(mm * 1e3) / 1e3, Quantity::Length, unit, QLocale());
    };
    findings.push_back({ProgramFinding::Weight::Error, static_cast<int>(each.line), 0,
                        collisionText(each, trial.path()).arg(length(2.0 * each.at.x()), length(each.at.y())),
                        moveOf(each, trial.path())});
  }
  for (const auto* notes : {&trial.path().notes, &trial.notes()}) {
    for (const ToolPath::Note& note : *notes)
      findings.push_back({ProgramFinding::Weight::Note, static_cast<int>(note.line), 0,
                          QString::fromStdString(note.text), std::nullopt});
  }
  return findings;
}

QString ProgramSession::summaryOf(const ProgramTrial& trial) const {
  const auto count = static_cast<int>(trial.collisionCount());
  const QString collisions = count > 0 ? tr("%n collision(s).", nullptr, count) : tr("No collision.");
  if (!trial.part()) return tr("The program does not touch the part. %1").arg(collisions);
  return tr("Time with tool changes %1. It removes %2 mm³. %3")
      .arg(programTime(trial.path().time), QLocale().toString(trial.removed(), 'f', 0), collisions);
}

bool ProgramSession::isCuttable() const {
  return m_trial && m_trial->part();
}

QString ProgramSession::cuttingTip() const {
  if (!isCuttable()) return tr("The program does not touch the part.");
  return m_trial->collisionCount() == 0
             ? tr("Cut the part as the program does: one step of the history")
             : tr("Cut the part as the program does. If it collides, its collisions are shown first.");
}

void ProgramSession::leave() {
  forgetRun();
  m_panel->setSummary(tr("The view shows the part as it is. Run the program to see what it would cut."));
}

void ProgramSession::cut() {
  if (isRefused()) return;
  if (!isCuttable()) return;
  if (m_trial->collisionCount() > 0) return askToCut();
  cutAnyway(m_trial);
}

// Before anything is struck. Not modal: the lines are in the list, and can be looked at first.
void ProgramSession::askToCut() {
  constexpr int kMostInMessage = 3;
  const auto count = static_cast<int>(m_trial->collisionCount());
  QStringList lines;
  for (const ProgramFinding& each : findingsOf(*m_trial))
    if (each.move && lines.size() < kMostInMessage) lines << tr("Line %1: %2").arg(each.line).arg(each.text);
  if (count > lines.size()) lines << tr("…and %1 more, in the list of the program.").arg(count - lines.size());
  Message question{
      Message::Weight::Warning, tr("The program has %n collision(s); nothing is cut yet", nullptr, count),
      lines.join(QLatin1Char(' ')),
      tr("If you cut anyway, collisions are recorded as on the machine, and undo does not take them back.")};
  question.actionText = tr("Cut anyway");
  question.action = [session = QPointer(this), trial = m_trial] {
    if (session) session->cutAnyway(trial);
  };
  question.otherText = tr("Cancel");
  question.other = [] {};
  question.about = &m_document.document;
  question.isOver = [session = QPointer(this), trial = m_trial] { return !session || session->m_trial != trial; };
  emit message(question);
}

void ProgramSession::cutAnyway(const ProgramTrial::Pointer& asked) {
  if (asked != m_trial || !isSameWork(m_start, workpiece().workpiece()))
    return m_panel->setSummary(tr("The program or the part was changed since: run it again."));
  const QString text = m_path.isEmpty() ? tr("Run program") : tr("Run %1").arg(fileName());
  const ProgramTrial::Pointer trial = asked;  // the commit lets go of it
  QString done = tr("Cut: %1 mm³ removed. Undo restores them.").arg(QLocale().toString(trial->removed(), 'f', 0));
  if (const auto count = static_cast<int>(trial->collisionCount()); count > 0)
    done += QLatin1Char(' ') + tr("%n collision(s) recorded, which undo does not take back.", nullptr, count);
  static_cast<WorkpieceDocument&>(m_document.document).addCrashes(trial->crashes());
  m_document.document.commit(text, std::make_unique<TurnedPartEdit>(trial->part()));
  m_panel->setSummary(done);
}

// The tool at once, the part as soon as a worker has it.
void ProgramSession::goTo(const ProgramPosition& position) {
  m_position = position;
  const ProgramTimeline& steps = m_trial->steps();
  m_panel->player().setTime(steps.timeAt(position));
  m_panel->editor().setCurrentLine(static_cast<int>(steps.lineAt(position)));
  if (!m_trial->path().moves.empty()) {
    const ToolMove& move = steps.moveAt(position);
    m_picture.tool = toolOutline(m_trial->setup().toolOf(move), m_trial->setup().dialect, steps.tipAt(position),
                                 programZero(m_start));
  }
  showPart();
  emit pictureChanged();
}

void ProgramSession::showPart() {
  const bool isUpToDate = m_picture.part && m_shown == m_position;
  if (m_isShowing || isUpToDate) return;
  m_isShowing = true;
  Job job;
  job.name = tr("Cutting up to the line");
  job.failed = [this](const Error&) { m_isShowing = false; };
  job.work = [this, trial = m_trial, position = m_position, played = m_played](Progress progress) -> Job::Finish {
    const std::optional<ProgramTrial::Moment> moment = trial->at(position, progress);
    const auto model =
        moment ? std::make_shared<const DisplayModel>(played->at(moment->profile, moment->threads)) : nullptr;
    return [this, trial, position, model] {
      m_isShowing = false;
      if (trial == m_trial) {
        m_picture.part = model;
        m_shown = position;
        emit pictureChanged();
      }
      if (m_trial) showPart();
    };
  };
  m_views.start(std::move(job));
}

// Looks at the tool where it is out of sight.
void ProgramSession::showPosition() {
  Box box;
  for (const auto& outline : m_picture.tool)
    for (const Vec3& p : outline) box.extend(p);
  Viewport& view = m_parts.viewport;
  const CameraNavigation navigation(view.camera(), {view.width(), view.height()});
  const Vec2 at = box.isEmpty() ? Vec2(-1, -1) : Vec2(navigation.toScreen(box.center()));
  const bool isInView = at.x() >= 0.0 && at.y() >= 0.0 && at.x() <= view.width() && at.y() <= view.height();
  if (box.isEmpty() || isInView) return;
  const double room = 0.5 * m_start.stock.diameter;  // room around the part
  view.flyTo(Box(box.min() - Vec3::Constant(room), box.max() + Vec3::Constant(room)), Vec3::Zero());
}

void ProgramSession::choose(const ProgramFinding& finding) {
  m_panel->player().setPlaying(false);
  if (finding.line > 0) m_panel->editor().goTo(finding.line, std::max(1, finding.column));
  m_panel->editor().setFocus();
  if (!m_trial || !finding.move) return;
  goTo({*finding.move + 1, 0.0});
  m_panel->editor().setCurrentLine(finding.line);
  showPosition();
}

}  // namespace handwheel
