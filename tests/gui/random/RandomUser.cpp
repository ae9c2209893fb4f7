// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomUser.h"

#include "../window/StlFiles.h"
#include "MeshShapes.h"
#include "controls/CommandPalette.h"
#include "document/DocumentKind.h"
#include "viewport/Viewport.h"
#include "volume/image/NrrdWriter.h"
#include "window/MainWindow.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/Samples.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QtTest>
#include <cstdio>

namespace handwheel::test {

namespace {

constexpr int kMostDocuments = 7;

// Returns two tori that pass through each other, holes, a flap that is open, and a piece of debris.
std::vector<Corners> damagedPart() {
  std::vector<Corners> part = quadTorus(24, 12, {{0, 3}, {6, 3}, {6, 4}, {12, 9}});
  for (Corners t : quadTorus(12, 8, {{2, 2}})) {
    for (Corner& c : t) c[0] += 25.0f;
    part.push_back(t);
  }
  part.push_back({{{90, 0, 0}, {92, 0, 0}, {90, 2, 0}}});
  part.push_back({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}});
  return part;
}

// Returns an open sheet of side x side quads.
std::vector<Corners> sheet(int side) {
  std::vector<Corners> triangles;
  const auto at = [](int i, int j) -> Corner { return {float(i), float(j), float((i * 7 + j * 3) % 5) * 0.1f}; };
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      if (i == side / 2 && j == side / 2) continue;
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return triangles;
}

template <class Widget>
std::vector<Widget*> visible(const QWidget& in) {
  std::vector<Widget*> found;
  for (Widget* each : in.findChildren<Widget*>()) {
    if (each->isVisible() && each->isEnabled() && each->window() == in.window()) found.push_back(each);
  }
  return found;
}

// Returns a scan of two balls, one within reach of a threshold and one of noise.
std::string scan() {
  constexpr int kSide = 24;
  const ImageGrid grid{{kSide, kSide, kSide}, Vec3::Zero(), 0.5 * Eigen::Matrix3d::Identity()};
  std::vector<std::int16_t> samples;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const Vec3 at(i % kSide, i / kSide % kSide, i / kSide / kSide);
    const double depth = std::max(5.0 - (at - Vec3(8, 8, 8)).norm(), 4.0 - (at - Vec3(17, 16, 15)).norm());
    samples.push_back(static_cast<std::int16_t>(std::clamp(200.0 * depth, -1000.0, 1000.0) + i % 7));
  }
  return nrrdOf(ImageVolume(grid, std::move(samples)));
}

}  // namespace

RandomUser::RandomUser(MainWindow& window, const DocumentKinds& kinds, std::uint32_t seed)
    : m_window(window), m_kinds(kinds), m_tabs(*window.findChild<DocumentTabs*>()), m_random(seed) {
  makeFiles();
  m_window.findChild<QAction*>(QStringLiteral("quit"))->setEnabled(false);
  connect(&m_tabs, &DocumentTabs::added, this, [this](DocumentTab* open) { keepOpened(*open); });
  connect(&m_tabs, &DocumentTabs::closing, this, &RandomUser::watchClosing);
  // A button with a menu waits within its press until something is chosen there, or the menu is closed.
  connect(&m_menus, &QTimer::timeout, this, [this] {
    if (qobject_cast<QMenu*>(QApplication::activePopupWidget())) pressKey();
  });
}

void RandomUser::makeFiles() {
  const auto add = [this](const char* name, const std::vector<Corners>& triangles) {
    m_files << m_folder.filePath(QString::fromLatin1(name));
    writeStl(m_files.last(), triangles);
  };
  add("whole.stl", quadTorus(12, 8, {}));
  add("holes.stl", quadTorus(48, 24, {{0, 3}, {8, 3}, {9, 3}, {16, 3}, {24, 20}, {30, 20}}));
  add("damaged.stl", damagedPart());
  add("sheet.stl", sheet(12));
  add("empty.stl", {});
  m_files << m_folder.filePath(QStringLiteral("broken.stl"));
  QFile broken(m_files.last());
  if (!broken.open(QIODevice::WriteOnly) || broken.write("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 n") < 0)
    qFatal("no room for test files");
  m_files << m_folder.filePath(QStringLiteral("missing.stl"));
  for (const char* sample : {"robot-cell.handwheel", "shaft-stock.handwheel", "robot-arm.urdf",
                             "thread-m20.exercise.json", "first-lesson.exercise.json"})
    m_files << samplePath(QString::fromLatin1(sample));
  m_files << m_folder.filePath(QStringLiteral("scan.nrrd"));
  QFile image(m_files.last());
  if (!image.open(QIODevice::WriteOnly) || image.write(QByteArray::fromStdString(scan())) < 0)
    qFatal("no room for test files");
  m_files << m_folder.filePath(QStringLiteral("volume.handwheel"));
  const DocumentKind& volume = *m_kinds.withId("volume");
  const auto made = volume.ofSurface(cube(20.0), {}, Progress());
  if (!made || !saveDocument(volume, {}, **made, m_files.last().toStdString())) qFatal("no volume");
}

void RandomUser::note(const QString& what) {
  std::printf("%s\n", qPrintable(what));
  std::fflush(stdout);
}

void RandomUser::watchClosing(DocumentTab* document) {
  const QString name = document->document.name();
  note(QStringLiteral("closes: %1").arg(name));
  if (!m_mayClose) m_problems << QStringLiteral("%1 closed, which nobody asked for").arg(name);
  if (document->document.isModified() && !std::exchange(m_mayDiscard, false))
    m_problems << QStringLiteral("%1 closed with unsaved changes").arg(name);
  m_opened.erase(document);
}

QWidget* RandomUser::target() const {
  if (QWidget* popup = QApplication::activePopupWidget()) return popup;
  if (QWidget* modal = QApplication::activeModalWidget()) return modal->focusWidget() ? modal->focusWidget() : modal;
  QWidget* focused = m_window.focusWidget();
  return focused ? focused : &m_window;
}

void RandomUser::act() {
  using Action = void (RandomUser::*)();
  // Each is chosen as often as it is listed.
  static constexpr Action kActions[] = {
      &RandomUser::openFile,       &RandomUser::pressKey,       &RandomUser::pressKey,     &RandomUser::pressKey,
      &RandomUser::pressKey,       &RandomUser::pressKey,       &RandomUser::strokeInView, &RandomUser::strokeInView,
      &RandomUser::strokeInView,   &RandomUser::clickButton,    &RandomUser::clickButton,  &RandomUser::clickRow,
      &RandomUser::clickRow,       &RandomUser::runCommand,     &RandomUser::runCommand,   &RandomUser::editField,
      &RandomUser::switchDocument, &RandomUser::switchDocument, &RandomUser::cancelJob,    &RandomUser::searchCommand,
      &RandomUser::runAction,      &RandomUser::runAction};
  // The choice there may be the command that closes.
  if (const auto* palette = m_window.findChild<CommandPalette*>(); palette && palette->isVisible()) m_mayClose = true;
  m_menus.start(50);
  if (!answerDialogs()) (this->*kActions[upTo(static_cast<int>(std::size(kActions)))])();
  m_menus.stop();
  QTest::qWait(upTo(30));
  if (oneIn(40)) {
    note(QStringLiteral("waits for the jobs"));
    (void)QTest::qWaitFor([this] { return m_window.isSettled() || QApplication::activeModalWidget(); }, 20'000);
    if (m_window.isSettled() && !QApplication::activeModalWidget() && !QApplication::activePopupWidget()) check();
  }
  // A command to close may wait for a prompt or a save; it has ended when all is quiet.
  if (m_mayClose && m_window.isSettled() && !QApplication::activeModalWidget()) m_mayClose = m_mayDiscard = false;
}

bool RandomUser::answerDialogs() {
  QWidget* modal = QApplication::activeModalWidget();
  if (!modal) return false;
  if (auto* prompt = qobject_cast<QMessageBox*>(modal)) {
    answer(*prompt);
  } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
    answer(*dialog);
  } else if (auto* other = qobject_cast<QDialog*>(modal)) {
    answer(*other);
  }
  return true;
}

// Any values that may be entered, some of them by hand. A value that the dialog refuses keeps it open.
void RandomUser::answer(QDialog& dialog) {
  const auto fields = visible<QLineEdit>(dialog);
  if (!fields.empty() && oneIn(3))
    return enter(*fields[static_cast<std::size_t>(upTo(static_cast<int>(fields.size())))]);
  const bool isAccepted = oneIn(2);
  note(QStringLiteral("%1 the dialog %2").arg(isAccepted ? "accepts" : "closes", dialog.objectName()));
  isAccepted ? dialog.accept() : dialog.reject();
}

void RandomUser::answer(QMessageBox& prompt) {
  if (prompt.objectName() == QLatin1String("memoryQuestion")) return prompt.reject();  // there is not that much
  const auto buttons = prompt.buttons();
  QAbstractButton* button = buttons[upTo(static_cast<int>(buttons.size()))];
  note(QStringLiteral("answers: %1").arg(button->text()));
  m_mayDiscard = m_mayDiscard || prompt.standardButton(button) == QMessageBox::Discard;
  button->click();
}

// Saved files go into the folder of this user.
void RandomUser::answer(QFileDialog& dialog) {
  if (oneIn(3)) {
    note(QStringLiteral("leaves %1").arg(dialog.objectName()));
    return dialog.reject();
  }
  const bool saves = dialog.acceptMode() == QFileDialog::AcceptSave;
  const QString file = saves ? m_folder.filePath(QStringLiteral("saved-%1.%2").arg(upTo(4)).arg(dialog.defaultSuffix()))
                             : m_files[upTo(static_cast<int>(m_files.size()))];
  note(QStringLiteral("%1: %2").arg(dialog.objectName(), file));
  dialog.findChild<QAbstractItemView*>(QStringLiteral("listView"))->clearSelection();
  dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
  // A prompt about a missing or existing file comes before accept() returns.
  QTimer asked;
  QObject::connect(&asked, &QTimer::timeout, &dialog, [this] {
    if (auto* prompt = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) answer(*prompt);
  });
  asked.start(20);
  QMetaObject::invokeMethod(&dialog, "accept");
  if (saves && !m_files.contains(file)) m_files << file;  // to be opened again
}

void RandomUser::openFile() {
  if (static_cast<int>(m_tabs.all().size()) >= kMostDocuments) return;
  const QString file = m_files[upTo(static_cast<int>(m_files.size()))];
  note(QStringLiteral("opens %1").arg(file));
  m_window.openPaths({file});
}

void RandomUser::pressKey() {
  struct Press {
    Qt::Key key;
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  };
  static constexpr Press kPresses[] = {{Qt::Key_N},
                                       {Qt::Key_N, Qt::ShiftModifier},
                                       {Qt::Key_N},
                                       {Qt::Key_Return},
                                       {Qt::Key_Return},
                                       {Qt::Key_Escape},
                                       {Qt::Key_Space},
                                       {Qt::Key_Space},
                                       {Qt::Key_Tab},
                                       {Qt::Key_Tab, Qt::ShiftModifier},
                                       {Qt::Key_K},
                                       {Qt::Key_P},
                                       {Qt::Key_H},
                                       {Qt::Key_S},
                                       {Qt::Key_B},
                                       {Qt::Key_T},
                                       {Qt::Key_R},
                                       {Qt::Key_W},
                                       {Qt::Key_U},
                                       {Qt::Key_J},
                                       {Qt::Key_M},
                                       {Qt::Key_F},
                                       {Qt::Key_D},
                                       {Qt::Key_Delete},
                                       {Qt::Key_Up},
                                       {Qt::Key_Down},
                                       {Qt::Key_Left},
                                       {Qt::Key_Right},
                                       {Qt::Key_BracketLeft},
                                       {Qt::Key_BracketRight},
                                       {Qt::Key_1},
                                       {Qt::Key_5},
                                       {Qt::Key_Z, Qt::ControlModifier},
                                       {Qt::Key_Z, Qt::ControlModifier},
                                       {Qt::Key_Y, Qt::ControlModifier},
                                       {Qt::Key_A, Qt::ControlModifier},
                                       {Qt::Key_R, Qt::ControlModifier},
                                       {Qt::Key_S, Qt::ControlModifier},
                                       {Qt::Key_PageUp, Qt::ControlModifier},
                                       {Qt::Key_PageDown, Qt::ControlModifier},
                                       {Qt::Key_W, Qt::ControlModifier}};
  const Press& press = kPresses[upTo(static_cast<int>(std::size(kPresses)))];
  if (press.key == Qt::Key_W && press.modifiers == Qt::ControlModifier) m_mayClose = true;
  note(QStringLiteral("presses %1 in %2")
           .arg(QKeySequence(press.key | press.modifiers).toString(), target()->objectName()));
  QTest::keyClick(target(), press.key, press.modifiers);
}

void RandomUser::strokeInView() {
  auto* view = m_window.findChild<Viewport*>();
  if (!view->isVisible() || QApplication::activePopupWidget()) return;
  static constexpr Qt::KeyboardModifier kModifiers[] = {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier,
                                                        Qt::ShiftModifier, Qt::ControlModifier};
  static constexpr Qt::MouseButton kButtons[] = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton,
                                                 Qt::RightButton};
  const auto modifiers = kModifiers[upTo(5)];
  const auto button = kButtons[upTo(5)];
  QPoint point(upTo(view->width()), upTo(view->height()));
  const int moves = oneIn(2) ? 0 : 1 + upTo(15);
  note(QStringLiteral("button %1 with %2, %3 moves from %4, %5")
           .arg(button)
           .arg(modifiers)
           .arg(moves)
           .arg(point.x())
           .arg(point.y()));
  QTest::mouseMove(view, point);
  if (oneIn(10)) return QTest::mouseDClick(view, button, modifiers, point);
  QTest::mousePress(view, button, modifiers, point);
  for (int i = 0; i < moves; ++i) {
    point += QPoint(upTo(61) - 30, upTo(61) - 30);
    QTest::mouseMove(view, point);
    if (oneIn(30)) pressKey();
  }
  QTest::mouseRelease(view, button, modifiers, point);
}

void RandomUser::clickButton() {
  const auto buttons = visible<QAbstractButton>(m_window);
  if (buttons.empty() || QApplication::activePopupWidget()) return;
  QAbstractButton* button = buttons[static_cast<std::size_t>(upTo(static_cast<int>(buttons.size())))];
  const QString name = button->objectName();
  note(QStringLiteral("clicks %1 “%2”").arg(name, button->text()));
  if (name == QLatin1String("closeTab")) m_mayClose = true;
  // Like a hand: the effects of the press happen before the release.
  const QPointer<QAbstractButton> pressed(button);
  QTest::mousePress(button, Qt::LeftButton);
  QTest::qWait(upTo(20));
  if (pressed && !QApplication::activeModalWidget()) QTest::mouseRelease(button, Qt::LeftButton);
}

void RandomUser::clickRow() {
  const auto views = visible<QAbstractItemView>(m_window);
  if (views.empty() || QApplication::activePopupWidget()) return;
  QAbstractItemView* view = views[static_cast<std::size_t>(upTo(static_cast<int>(views.size())))];
  const QAbstractItemModel* model = view->model();
  if (!model || model->rowCount() == 0) return;
  QModelIndex index = model->index(upTo(model->rowCount()), 0);
  if (model->rowCount(index) > 0 && !oneIn(4)) index = model->index(upTo(model->rowCount(index)), 0, index);
  note(QStringLiteral("row %1 of %2").arg(index.data().toString(), view->objectName()));
  view->scrollTo(index);
  const QPoint point = view->visualRect(index).center();
  oneIn(4) ? QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, point)
           : QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, point);
}

void RandomUser::runCommand() {
  QList<QAction*> actions;
  for (const QMenu* menu : m_window.findChildren<QMenu*>()) {
    for (QAction* action : menu->actions()) {
      if (action->isEnabled() && action->isVisible() && !action->menu() && !action->isSeparator()) actions << action;
    }
  }
  if (actions.isEmpty() || QApplication::activePopupWidget()) return;
  QAction* action = actions[upTo(static_cast<int>(actions.size()))];
  const QString name = action->objectName();
  if (static_cast<int>(m_tabs.all().size()) >= kMostDocuments &&
      (name.startsWith(QLatin1String("open")) || name.startsWith(QLatin1String("new"))))
    return;
  note(QStringLiteral("command %1 “%2”").arg(name, action->text()));
  if (name == QLatin1String("closeDocument")) m_mayClose = true;
  action->trigger();
}

// Any command, also those that are in no menu.
void RandomUser::runAction() {
  QList<QAction*> actions;
  for (QAction* action : m_window.findChildren<QAction*>())
    if (action->isEnabled() && !action->menu() && !action->isSeparator() && !action->objectName().isEmpty())
      actions << action;
  if (actions.isEmpty() || QApplication::activePopupWidget()) return;
  QAction* action = actions[upTo(static_cast<int>(actions.size()))];
  const QString name = action->objectName();
  const bool opens = name.startsWith(QLatin1String("open")) || name.startsWith(QLatin1String("new"));
  if (opens && static_cast<int>(m_tabs.all().size()) >= kMostDocuments) return;
  note(QStringLiteral("action %1").arg(name));
  if (name == QLatin1String("closeDocument")) m_mayClose = true;
  action->trigger();
}

void RandomUser::editField() {
  const auto fields = visible<QLineEdit>(m_window);
  if (!fields.empty()) enter(*fields[static_cast<std::size_t>(upTo(static_cast<int>(fields.size())))]);
}

void RandomUser::enter(QLineEdit& line) {
  QLineEdit* const field = &line;
  if (field->isReadOnly()) return;
  static const QStringList kTexts{"0", "1", "-3", "1e9", "25.4/2", "0.01", "nonsense", "", "1e-300", "7 mm"};
  const QString text = kTexts[upTo(static_cast<int>(kTexts.size()))];
  note(QStringLiteral("types “%1” into %2").arg(text, field->parentWidget()->objectName()));
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, text);
  QTest::keyClick(field, oneIn(4) ? Qt::Key_Escape : Qt::Key_Return);
}

void RandomUser::switchDocument() {
  const auto count = static_cast<int>(m_tabs.all().size());
  if (count == 0) return openFile();
  const DocumentTab* next = m_tabs.all()[static_cast<std::size_t>(upTo(count))].get();
  note(QStringLiteral("shows %1").arg(next->document.name()));
  m_tabs.setCurrent(next);
}

void RandomUser::cancelJob() {
  auto* cancel = m_window.findChild<QAbstractButton*>(QStringLiteral("jobCancel"));
  if (!cancel || !cancel->isVisible()) return;
  note(QStringLiteral("cancels a job"));
  QTest::mouseClick(cancel, Qt::LeftButton);
}

void RandomUser::searchCommand() {
  if (QApplication::activePopupWidget()) return;
  m_window.findChild<QAction*>(QStringLiteral("searchCommands"))->trigger();
  auto* query = m_window.findChild<QLineEdit*>(QStringLiteral("commandQuery"));
  if (!query) return;
  static const QStringList kQueries{"re", "fill", "undo", "sec", "view", "x", "zz", "hole"};
  const QString text = kQueries[upTo(static_cast<int>(kQueries.size()))];
  note(QStringLiteral("searches “%1”").arg(text));
  m_mayClose = true;  // the command found may be the one that closes
  QTest::keyClicks(query, text);
  QTest::keyClick(query, oneIn(2) ? Qt::Key_Return : Qt::Key_Escape);
}

}  // namespace handwheel::test
