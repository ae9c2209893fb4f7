// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The text of a program. ProgramSessionFile.cpp has its file, ProgramSessionRun.cpp and ProgramSessionMake.cpp its use.
#include "window/workpiece/program/ProgramSession.h"

#include "controls/program/ProgramEditor.h"
#include "document/workpiece/ProgramToolsEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramCheck.h"
#include "machining/program/ProgramErrors.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "window/ActionToolTip.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/workpiece/program/ProgramPlayer.h"

#include <QFileInfo>
#include <algorithm>
#include <charconv>
#include <utility>

namespace handwheel {

namespace {

constexpr int kPauseMs = 500;  // after the last key, before the text is checked

// Columns of errors count bytes of UTF-8, those of the editor characters.
int columnIn(const QString& line, const std::string& bytes) {
  int column = 0;
  std::from_chars(bytes.data(), bytes.data() + bytes.size(), column);
  if (column <= 0) return 0;
  return static_cast<int>(QString::fromUtf8(line.toUtf8().left(column - 1)).size()) + 1;
}

ProgramFinding findingOf(const Error& error, const QTextDocument& text) {
  ProgramFinding finding;
  finding.weight = ProgramFinding::Weight::Error;
  if (error.position.kind == InputPosition::Kind::Line) finding.line = static_cast<int>(error.position.value);
  if (error.code == ProgramError::Refused && error.arguments.size() >= 4) {
    finding.column = columnIn(text.findBlockByNumber(finding.line - 1).text(), error.arguments[0]);
    finding.text = ProgramSession::tr("%1: %2. %3")
                       .arg(QString::fromStdString(error.arguments[1]), QString::fromStdString(error.arguments[2]),
                            QString::fromStdString(error.arguments[3]));
    return finding;
  }
  Error bare = error;
  bare.position = {};
  finding.text = errorSentence(bare) + QLatin1Char(' ') + errorAdvice(bare);
  return finding;
}

}  // namespace

ProgramSession::ProgramSession(const WindowContext& parts, DocumentTab& document, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_document(document),
      m_checks(JobRunner::Policy::Latest, parts.pool),
      m_runs(JobRunner::Policy::Queue, parts.pool),
      m_views(JobRunner::Policy::Queue, parts.pool),
      m_files(JobRunner::Policy::Queue, parts.pool) {
  m_isByHand = isToBeDoneByHand();
  prepareActions();
  m_panel = new ProgramPanel({&m_open, &m_save, &m_saveAs, &m_fromPasses, &m_cycles}, parts.window);
  m_panel->hide();
  connectPanel();
  connect(&document.document, &Document::changed, this, &ProgramSession::documentChanged);
  m_pause.setSingleShot(true);
  m_pause.setInterval(kPauseMs);
  connect(&m_pause, &QTimer::timeout, this, &ProgramSession::check);
  showName();
  documentChanged();
  isRefused();
}

ProgramSession::~ProgramSession() {
  if (!m_panel) return;
  m_panel->editor().document()->disconnect(this);
  m_panel->editor().disconnect(this);
  m_panel->player().disconnect(this);
  delete m_panel;
}

void ProgramSession::prepareActions() {
  const auto named = [](QAction& action, const char* name, const char* iconName, const QString& text,
                        const QString& tip) {
    action.setText(text);
    prepare(action, name, iconName, tip);
  };
  named(m_open, "openProgram", "open", tr("&Open program…"), tr("Open a program: .ngc, .nc, .tap or .txt"));
  named(m_save, "saveProgram", "save", tr("&Save program"), tr("Save the program in its file (Ctrl+S in the text)"));
  named(m_saveAs, "saveProgramAs", "save-as", tr("Save program &as…"), tr("Save the program under another name"));
  named(m_fromPasses, "programFromPasses", nullptr, tr("Program from &passes…"),
        tr("Write the passes that cut this part as a program"));
  named(m_cycles, "roughAndFinish", nullptr, tr("&Rough and finish…"),
        tr("Write a program that makes the target from the part. It is simulated before it is shown."));
  connect(&m_open, &QAction::triggered, this, &ProgramSession::askForFile);
  connect(&m_save, &QAction::triggered, this, [this] { save({}); });
  connect(&m_saveAs, &QAction::triggered, this, [this] { askForName({}); });
  connect(&m_fromPasses, &QAction::triggered, this, &ProgramSession::askForPasses);
  connect(&m_cycles, &QAction::triggered, this, &ProgramSession::askForCycles);
}

void ProgramSession::connectPanel() {
  ProgramEditor& editor = m_panel->editor();
  connect(editor.document(), &QTextDocument::contentsChanged, this, [this, text = editor.document()] {
    const QString now = text->toPlainText();
    if (std::exchange(m_text, now) != now) textChanged();  // else it is marked or coloured only
  });
  connect(editor.document(), &QTextDocument::modificationChanged, this, &ProgramSession::showName);
  connect(&editor, &ProgramEditor::cursorLineChanged, this, [this](int line) {
    if (!m_trial || m_panel->player().isPlaying()) return;
    goTo(m_trial->steps().afterLine(static_cast<std::uint32_t>(line)));
  });
  connect(m_panel, &ProgramPanel::dialectChanged, this, &ProgramSession::dialectChanged);
  connect(m_panel, &ProgramPanel::noseChanged, this, [this] {
    if (!m_hasOwnTools) setTools({}, false);
    textChanged();
  });
  connect(m_panel, &ProgramPanel::controlChanged, this, &ProgramSession::textChanged);
  connect(m_panel, &ProgramPanel::postChosen, this, [this](const ProgramPost& post) {
    if (post == workpiece().workpiece().programPost) return;
    m_document.document.commit(tr("Change the tool post"), std::make_unique<ProgramPostEdit>(post));
  });
  connect(m_panel, &ProgramPanel::toolsRequested, this, &ProgramSession::askForTools);
  connect(m_panel, &ProgramPanel::runRequested, this, &ProgramSession::run);
  connect(m_panel, &ProgramPanel::cancelRequested, &m_runs, &JobRunner::cancelAll);
  connect(m_panel, &ProgramPanel::cutRequested, this, &ProgramSession::cut);
  connect(m_panel, &ProgramPanel::findingChosen, this, &ProgramSession::choose);
  connect(m_panel, &ProgramPanel::dropped, this, &ProgramSession::read);
  connect(m_panel, &ProgramPanel::saveRequested, this, [this] { save({}); });
  connect(&m_panel->player(), &ProgramPlayer::timeWanted, this, [this](double time) {
    if (m_trial) goTo(m_trial->steps().at(time));
  });
  connect(&m_panel->player(), &ProgramPlayer::stepWanted, this, [this](bool isBack) {
    if (!m_trial) return;
    const ProgramTimeline& steps = m_trial->steps();
    goTo(isBack ? steps.previous(m_position) : steps.next(m_position));
    showPosition();
  });
  connect(&m_runs, &JobRunner::progressed, this, [this] {
    const std::vector<JobStatus> jobs = m_runs.jobs();
    if (m_panel && !jobs.empty()) m_panel->setProgress(jobs.front().fraction);
  });
  connect(&m_runs, &JobRunner::changed, this, [this] {
    if (m_panel) m_panel->setRunning(!m_runs.isIdle());
  });
}

const WorkpieceDocument& ProgramSession::workpiece() const {
  return static_cast<const WorkpieceDocument&>(m_document.document);
}

ProgramSetup ProgramSession::setup() const {
  const WorkpieceSnapshot& work = workpiece().workpiece();
  ProgramSetup setup = programSetupFor(work, shippedLatheTools(), m_panel->dialect(), m_panel->nose());
  setup.tools = m_tools;
  m_panel->applyControl(setup);
  return setup;
}

void ProgramSession::setTools(ProgramTools tools, bool isOwn) {
  m_tools = std::move(tools);
  m_hasOwnTools = isOwn && !m_tools.empty();
  m_panel->setToolCount(m_tools.size());
}

// The table of the document is that of the text, whatever had its tools before.
void ProgramSession::takeStoredTools() {
  const auto stored = workpiece().workpiece().programTools;
  if (std::exchange(m_storedTools, stored) == stored) return;
  setTools(stored ? inDialect(*stored, ProgramDialect::LinuxCnc, m_panel->dialect()) : ProgramTools(), true);
  textChanged();
}

void ProgramSession::storeTools(const ProgramTools& chosen) {
  if (toolTableText(chosen) == toolTableText(m_tools) && m_hasOwnTools == !chosen.empty()) return;
  auto stored =
      chosen.empty()
          ? nullptr
          : std::make_shared<const ProgramTools>(inDialect(chosen, m_panel->dialect(), ProgramDialect::LinuxCnc));
  // The tools of a text that was written for the target are not in the document, and go without an undo step.
  if (!stored && !m_storedTools) {
    setTools({}, false);
    return textChanged();
  }
  m_document.document.commit(tr("Change the tools of the program"),
                             std::make_unique<ProgramToolsEdit>(std::move(stored)));
}

void ProgramSession::dialectChanged() {
  const ProgramDialect now = m_panel->dialect();
  const ProgramDialect before = now == ProgramDialect::Fanuc ? ProgramDialect::LinuxCnc : ProgramDialect::Fanuc;
  m_tools = inDialect(std::move(m_tools), before, now);
  textChanged();
}

bool ProgramSession::isSettled() const {
  return !m_pause.isActive() && m_checks.isIdle() && m_runs.isIdle() && m_views.isIdle() && m_files.isIdle();
}

bool ProgramSession::isUnsaved() const {
  const QTextDocument* const text = m_panel->editor().document();
  return text->isModified() && (!text->isEmpty() || !m_path.isEmpty());
}

QString ProgramSession::fileName() const {
  return m_path.isEmpty() ? tr("Untitled program") : QFileInfo(m_path).fileName();
}

void ProgramSession::showName() {
  const bool isBlank = m_path.isEmpty() && m_panel->editor().document()->isEmpty();
  m_panel->setName(isBlank ? QString() : isUnsaved() ? fileName() + QStringLiteral(" •") : fileName());
}

void ProgramSession::textChanged() {
  forgetRun();
  m_runs.cancelAll();
  m_pause.start();
  showName();
}

void ProgramSession::check() {
  const std::string text = m_panel->editor().toPlainText().toStdString();
  Job job;
  job.name = tr("Checking the program");
  job.work = [this, text, setup = setup()](Progress progress) -> Job::Finish {
    return [this, problems = programProblems(text, setup, progress)] { checked(problems, false); };
  };
  m_checks.start(std::move(job));
}

void ProgramSession::checked(const std::vector<Error>& problems, bool isJumping) {
  if (!m_panel || m_trial) return;
  std::vector<ProgramFinding> findings;
  for (const Error& each : problems) findings.push_back(findingOf(each, *m_panel->editor().document()));
  const auto count = static_cast<int>(findings.size());
  if (isJumping && count > 0) m_panel->editor().goTo(findings.front().line, std::max(1, findings.front().column));
  m_panel->setFindings(std::move(findings));
  m_panel->setSummary(count > 0 ? tr("%n error(s): the program does not run as it is.", nullptr, count) : QString());
  if (count == 0) isRefused();
}

void ProgramSession::fail(const QString& title, const Error& error) {
  if (error.code == ErrorCode::Cancelled) return;
  emit message({Message::Weight::Error, title, errorSentence(error), errorAdvice(error)});
}

}  // namespace handwheel
