// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/CommandPalette.h"

#include "controls/ActionText.h"
#include "controls/CommandDelegate.h"
#include "controls/CommandModel.h"
#include "theme/Icons.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QMenuBar>
#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kWidth = 560;
constexpr int kMargin = 16;  // pixels to the window's border
constexpr int kTop = 40;
constexpr int kRowsShown = 10;
constexpr int kLongestQuery = 64;
constexpr int kRemembered = 12;
const auto kRecentKey = QStringLiteral("palette/recent");

bool isUsed(int key) {
  constexpr int kKeys[] = {Qt::Key_Escape, Qt::Key_Return,   Qt::Key_Enter, Qt::Key_Up,     Qt::Key_Down,
                           Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Tab,   Qt::Key_Backtab};
  return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
}

}  // namespace

CommandPalette::CommandPalette(QMainWindow* window)
    : QFrame(window),
      m_window(window),
      m_action(new QAction(icon(QStringLiteral("search")), tr("&Search commands…"), window)),
      m_model(new CommandModel(this)),
      m_query(new QLineEdit(this)),
      m_list(new QListView(this)),
      m_nothing(new QLabel(tr("No matching command."), this)) {
  setObjectName(QStringLiteral("commandPalette"));
  setProperty("card", true);
  setAutoFillBackground(true);
  m_action->setObjectName(QStringLiteral("searchCommands"));
  m_action->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_K));
  m_action->setToolTip(tr("Find and run any command by its name (Ctrl+K)"));
  window->addAction(m_action);  // its key works wherever else the action is added
  connect(m_action, &QAction::triggered, this, &CommandPalette::popUp);
  m_query->setObjectName(QStringLiteral("commandQuery"));
  m_query->setPlaceholderText(tr("What do you want to do?"));
  m_query->setAccessibleName(tr("Search commands"));
  m_query->setMaxLength(kLongestQuery);
  m_query->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  for (QWidget* part : {static_cast<QWidget*>(m_query), static_cast<QWidget*>(m_list)}) part->installEventFilter(this);
  m_nothing->setObjectName(QStringLiteral("noCommand"));
  m_nothing->setProperty("muted", true);
  m_nothing->setContentsMargins(8, 0, 8, 4);
  m_list->setObjectName(QStringLiteral("commandList"));
  m_list->setAccessibleName(tr("Commands found"));
  m_list->setModel(m_model);
  m_list->setItemDelegate(new CommandDelegate(m_list));
  m_list->setFocusPolicy(Qt::NoFocus);  // the keys of the line move it
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setMouseTracking(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(8);
  column->addWidget(m_query);
  column->addWidget(m_list);
  column->addWidget(m_nothing);
  connect(m_query, &QLineEdit::textChanged, this, &CommandPalette::search);
  connect(m_list, &QListView::clicked, this, &CommandPalette::run);
  connect(m_list, &QListView::entered, m_list, &QListView::setCurrentIndex);
  hide();
}

void CommandPalette::popUp() {
  if (!isVisible()) m_before = QApplication::focusWidget();
  QList<QAction*> actions = commandsOf(*m_window);
  actions.removeOne(m_action);
  m_model->setActions(actions, menuPaths(m_window->findChild<QMenuBar*>()));
  m_model->setRecent(QSettings().value(kRecentKey).toStringList());
  m_query->clear();
  show();
  search();
  raise();
  m_query->setFocus(Qt::PopupFocusReason);
  m_window->installEventFilter(this);
}

void CommandPalette::hideEvent(QHideEvent* event) {
  m_window->removeEventFilter(this);
  if (m_before && m_query->hasFocus()) m_before->setFocus(Qt::PopupFocusReason);
  QFrame::hideEvent(event);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_window && event->type() == QEvent::Resize) place();
  // Meanwhile its keys are not those of the window's commands: Return would fill a selected hole.
  if (watched != m_window && event->type() == QEvent::ShortcutOverride &&
      isUsed(static_cast<QKeyEvent*>(event)->key())) {
    event->accept();
    return true;
  }
  if (watched != m_query) return QFrame::eventFilter(watched, event);
  if (event->type() == QEvent::FocusOut && static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason) {
    hide();
  }
  return event->type() == QEvent::KeyPress && useKey(static_cast<QKeyEvent*>(event));
}

// Moves in the list, runs or closes; returns false for a key of the line.
bool CommandPalette::useKey(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      hide();
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      run(m_list->currentIndex());
      return true;
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      QApplication::sendEvent(m_list, event);
      return true;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
      return true;  // nothing else to go to
    default:
      return false;
  }
}

void CommandPalette::search() {
  m_model->setQuery(m_query->text());
  m_list->setCurrentIndex(m_model->index(0, 0));
  place();
}

// Moves it to the middle of the top, as high as the results, or as the window allows.
void CommandPalette::place() {
  int height = 0;
  for (int row = 0; row < std::min(m_model->rowCount(), kRowsShown); ++row) height += m_list->sizeHintForRow(row);
  m_list->setVisible(m_model->rowCount() > 0);
  m_nothing->setVisible(m_model->rowCount() == 0);
  m_list->setFixedHeight(height + 2 * m_list->frameWidth());
  const int width = std::min(kWidth, m_window->width() - 2 * kMargin);
  const int room = m_window->height() - kTop - kMargin;
  if (sizeHint().height() > room) m_list->setFixedHeight(std::max(0, m_list->height() - sizeHint().height() + room));
  layout()->activate();
  setGeometry((m_window->width() - width) / 2, kTop, width, sizeHint().height());
}

void CommandPalette::run(const QModelIndex& index) {
  QAction* action = m_model->action(index);
  if (!action || !action->isEnabled()) return;  // the row shows the reason
  remember(action->objectName());
  hide();
  QTimer::singleShot(0, action, &QAction::trigger);  // it may well close the window, and this with it
}

void CommandPalette::remember(const QString& id) {
  QSettings settings;
  QStringList recent = settings.value(kRecentKey).toStringList();
  recent.removeAll(id);
  recent.prepend(id);
  settings.setValue(kRecentKey, recent.mid(0, kRemembered));
}

}  // namespace handwheel
