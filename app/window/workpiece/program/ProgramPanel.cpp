// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/ProgramPanel.h"

#include "controls/NumberField.h"
#include "controls/OwnKeys.h"
#include "controls/program/ProgramEditor.h"
#include "machining/TurningPass.h"
#include "theme/Icons.h"
#include "theme/Theme.h"
#include "window/workpiece/program/ControlButton.h"
#include "window/workpiece/program/ProgramPlayer.h"

#include <QAction>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kMostListHeight = 150;  // pixels
constexpr std::size_t kMostListed = 500;

QString fileIn(const QMimeData& data) {
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) return url.toLocalFile();
  return {};
}

QIcon iconOf(ProgramFinding::Weight weight) {
  const ThemeColours& colours = themeColours(currentTheme());
  switch (weight) {
    case ProgramFinding::Weight::Note:
      return icon(QStringLiteral("info"), colours.accent);
    case ProgramFinding::Weight::Warning:
      return icon(QStringLiteral("warning"), colours.warning);
    case ProgramFinding::Weight::Error:
      break;
  }
  return icon(QStringLiteral("error"), colours.error);
}

ProgramMark::Severity severityOf(ProgramFinding::Weight weight) {
  if (weight == ProgramFinding::Weight::Note) return ProgramMark::Severity::Note;
  return weight == ProgramFinding::Weight::Warning ? ProgramMark::Severity::Warning : ProgramMark::Severity::Error;
}

QToolButton* actionButton(QAction* action, Qt::ToolButtonStyle style, QWidget* parent) {
  auto* made = new QToolButton(parent);
  made->setObjectName(action->objectName() + QStringLiteral("Button"));
  made->setDefaultAction(action);
  made->setToolButtonStyle(style);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

QPushButton* runButton(const QString& text, const char* name, const QString& tip, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(QString::fromLatin1(name));
  made->setToolTip(tip);
  return made;
}

}  // namespace

ProgramPanel::ProgramPanel(const Actions& actions, QWidget* parent)
    : QWidget(parent),
      m_editor(new ProgramEditor(this)),
      m_player(new ProgramPlayer(this)),
      m_summary(new QLabel(this)),
      m_list(new QListWidget(this)) {
  setObjectName(QStringLiteral("programPanel"));
  setAcceptDrops(true);
  m_summary->setObjectName(QStringLiteral("programSummary"));
  m_summary->setTextFormat(Qt::PlainText);
  m_summary->setWordWrap(true);
  m_list->setObjectName(QStringLiteral("programFindings"));
  m_list->setAccessibleName(tr("Errors and collisions"));
  m_list->setToolTip(tr("A click jumps to the line, and shows the place of a collision."));
  m_list->setWordWrap(true);
  m_list->setMaximumHeight(kMostListHeight);
  m_list->hide();
  m_editor->setPlaceholderText(tr("Open a program, drop one here, or write one."));
  m_editor->installEventFilter(this);
  m_editor->viewport()->installEventFilter(this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(6);
  column->addWidget(makeFileRow(actions));
  column->addWidget(makeSetupRow());
  column->addWidget(makeRunRow());  // above widgets that come and go, so that it does not move
  column->addWidget(m_editor, 1);
  column->addWidget(m_summary);
  column->addWidget(m_list);
  column->addWidget(m_player);
  connect(m_list, &QListWidget::itemClicked, this, [this] { chosen(m_list->currentRow()); });
  new OwnKeys(*m_list, {Qt::Key_Return, Qt::Key_Enter});
  connect(m_list, &QListWidget::itemActivated, this, [this] { chosen(m_list->currentRow()); });
  setRunning(false);
  setCuttable(false, tr("Run the program first."));
}

QWidget* ProgramPanel::makeFileRow(const Actions& actions) {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(actionButton(actions.open, Qt::ToolButtonIconOnly, row));
  auto* save = actionButton(actions.save, Qt::ToolButtonIconOnly, row);
  save->setPopupMode(QToolButton::MenuButtonPopup);
  save->addAction(actions.saveAs);
  layout->addWidget(save);
  auto* make = new QToolButton(row);
  make->setObjectName(QStringLiteral("programMake"));
  make->setText(tr("Make"));
  make->setToolTip(tr("Generate a program from the recorded passes or for the target"));
  make->setPopupMode(QToolButton::InstantPopup);
  make->setFocusPolicy(Qt::StrongFocus);
  make->addActions({actions.fromPasses, actions.cycles});
  layout->addWidget(make);
  m_name = new QLabel(row);
  m_name->setObjectName(QStringLiteral("programName"));
  m_name->setTextFormat(Qt::PlainText);
  m_name->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long name does not widen the panel
  layout->addWidget(m_name, 1);
  return row;
}

// Two lines, which fit into the panel as it opens, in every language and with any number of tools.
QWidget* ProgramPanel::makeSetupRow() {
  constexpr int kShownLetters = 8;  // least number for the tool post
  auto* row = new QWidget(this);
  auto* lines = new QVBoxLayout(row);
  lines->setContentsMargins(0, 0, 0, 0);
  auto* layout = new QHBoxLayout;
  auto* second = new QHBoxLayout;
  lines->addLayout(layout);
  lines->addLayout(second);
  m_dialect = new QComboBox(row);
  m_dialect->setObjectName(QStringLiteral("programDialect"));
  m_dialect->setAccessibleName(tr("Dialect"));
  m_dialect->setToolTip(tr("The control for which the program is written. It is recognised when a program is opened."));
  m_dialect->addItem(tr("LinuxCNC"), static_cast<int>(ProgramDialect::LinuxCnc));
  m_dialect->addItem(tr("Fanuc, system A"), static_cast<int>(ProgramDialect::Fanuc));
  m_nose = new NumberField(row);
  m_nose->setObjectName(QStringLiteral("programNose"));
  m_nose->setQuantity(Quantity::Length, LengthUnit::Millimetre);
  m_nose->setRange(0.0, TurningPass::kLargestNose);
  m_nose->setValue(0.0);
  m_nose->setPrefix(QStringLiteral("R"));
  m_nose->setLabel(tr("Nose radius of the tools"));
  m_nose->setToolTip(tr("Nose radius of all tools; 0: the tools are points"));
  layout->addWidget(m_dialect);
  layout->addWidget(new QLabel(tr("Nose"), row));
  layout->addWidget(m_nose, 1);
  m_post = new QComboBox(row);
  m_post->setMinimumContentsLength(kShownLetters);
  m_post->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_post->setObjectName(QStringLiteral("programPost"));
  m_post->setAccessibleName(tr("Tool post"));
  m_post->setToolTip(tr(
      "Tool post of the machine, and the side that the inserts face: they decide between M3 and M4. X+ points to the "
      "post; seen from above, G2, G3, G41 and G42 appear reversed if it is in front."));
  m_post->addItem(tr("Behind, insert down (M3)"));
  m_post->addItem(tr("Behind, insert up (M4)"));
  m_post->addItem(tr("In front, insert down (M4)"));
  m_post->addItem(tr("In front, insert up (M3)"));
  second->addWidget(m_post, 1);
  connect(m_post, &QComboBox::activated, this, [this](int index) { emit postChosen({index >= 2, index % 2 == 1}); });
  m_tools = runButton({}, "programTools", tr("Tool table of the program: nose radii, holders and offsets"), row);
  second->addWidget(m_tools);
  m_control = new ControlButton(row);
  m_control->setDialect(dialect());
  second->addWidget(m_control);
  setToolCount(0);
  connect(m_control, &ControlButton::changed, this, &ProgramPanel::controlChanged);
  connect(m_dialect, &QComboBox::currentIndexChanged, this, [this] { m_control->setDialect(dialect()); });
  connect(m_dialect, &QComboBox::activated, this, &ProgramPanel::dialectChanged);
  connect(m_nose, &NumberField::valueEdited, this, &ProgramPanel::noseChanged);
  connect(m_tools, &QPushButton::clicked, this, &ProgramPanel::toolsRequested);
  return row;
}

QWidget* ProgramPanel::makeRunRow() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  m_run = runButton(tr("&Run"), "programRun", tr("Simulate the program on the part; the document stays as it is"), row);
  m_run->setIcon(icon(QStringLiteral("play")));
  m_cancel = runButton(tr("Cancel"), "programCancel", tr("Stop this run"), row);
  m_cut = runButton(tr("&Cut the work"), "programCut", {}, row);
  m_progress = new QProgressBar(row);
  m_progress->setObjectName(QStringLiteral("programProgress"));
  m_progress->setRange(0, 100);
  m_progress->setAccessibleName(tr("Progress of the run"));
  layout->addWidget(m_run);
  layout->addWidget(m_progress, 1);
  layout->addWidget(m_cancel);
  layout->addStretch();
  layout->addWidget(m_cut);
  connect(m_run, &QPushButton::clicked, this, &ProgramPanel::runRequested);
  connect(m_cancel, &QPushButton::clicked, this, &ProgramPanel::cancelRequested);
  connect(m_cut, &QPushButton::clicked, this, &ProgramPanel::cutRequested);
  return row;
}

QString ProgramPanel::name() const {
  return m_name->text();
}

void ProgramPanel::setName(const QString& name) {
  m_name->setText(name);
  m_name->setToolTip(name);
}

ProgramDialect ProgramPanel::dialect() const {
  return static_cast<ProgramDialect>(m_dialect->currentData().toInt());
}

void ProgramPanel::setDialect(ProgramDialect dialect) {
  m_dialect->setCurrentIndex(m_dialect->findData(static_cast<int>(dialect)));
}

void ProgramPanel::applyControl(ProgramSetup& setup) const {
  m_control->applyTo(setup);
}

double ProgramPanel::nose() const {
  return m_nose->value();
}

void ProgramPanel::setNose(double mm) {
  m_nose->setValue(mm);
}

// The items are in the order of their sides.
void ProgramPanel::setPost(const ProgramPost& post) {
  m_post->setCurrentIndex((post.isInFront ? 2 : 0) + (post.isInsertUp ? 1 : 0));
}

void ProgramPanel::setToolCount(std::size_t count) {
  m_tools->setText(count == 0 ? tr("&Tools…") : tr("&Tools (%1)…").arg(count));
}

void ProgramPanel::setFindings(std::vector<ProgramFinding> findings) {
  m_findings = std::move(findings);
  m_list->clear();
  std::vector<ProgramMark> marks;
  for (const ProgramFinding& each : m_findings) {
    if (each.line > 0) marks.push_back({each.line, each.column, severityOf(each.weight), each.text});
    if (static_cast<std::size_t>(m_list->count()) >= kMostListed) continue;
    const QString prefix = each.line == 0     ? QString()
                           : each.column == 0 ? tr("Line %1: ").arg(each.line)
                                              : tr("Line %1, column %2: ").arg(each.line).arg(each.column);
    m_list->addItem(new QListWidgetItem(iconOf(each.weight), prefix + each.text));
  }
  m_editor->setMarks(std::move(marks));
  m_list->setVisible(!m_findings.empty());
}

void ProgramPanel::chosen(int row) {
  if (row >= 0 && row < static_cast<int>(m_findings.size()))
    emit findingChosen(ProgramFinding(m_findings[static_cast<std::size_t>(row)]));
}

void ProgramPanel::setSummary(const QString& text) {
  m_summary->setText(text);
  m_summary->setVisible(!text.isEmpty());
}

void ProgramPanel::setRunning(bool isRunning) {
  m_run->setVisible(!isRunning);
  m_cut->setVisible(!isRunning);
  m_progress->setVisible(isRunning);
  m_cancel->setVisible(isRunning);
  m_progress->setValue(0);
}

void ProgramPanel::setProgress(double fraction) {
  m_progress->setValue(static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0)));
}

void ProgramPanel::setCuttable(bool isCuttable, const QString& why) {
  m_cut->setEnabled(isCuttable);
  m_cut->setToolTip(why);
}

void ProgramPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!fileIn(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ProgramPanel::dropEvent(QDropEvent* event) {
  const QString path = fileIn(*event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  emit dropped(path);
}

// A file that is dropped on the text is opened, and not pasted as its name; the key for saving saves the program.
bool ProgramPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove || event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    const QString path = fileIn(*drop->mimeData());
    if (path.isEmpty()) return QWidget::eventFilter(watched, event);
    drop->acceptProposedAction();
    if (event->type() == QEvent::Drop) emit dropped(path);
    return true;
  }
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (watched != m_editor || !isKey || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Save))
    return QWidget::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::KeyPress) emit saveRequested();
  return true;
}

}  // namespace handwheel
