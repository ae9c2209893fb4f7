// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "builtin/BuiltInKinds.h"
#include "panels/defects/DefectModel.h"
#include "viewport/Viewport.h"
#include "window/JobRunner.h"
#include "window/MainWindow.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSemaphore>
#include <QSettings>
#include <QSize>
#include <QTabBar>
#include <QTemporaryDir>
#include <QThreadPool>
#include <QToolButton>
#include <QTreeView>
#include <QtTest>
#include <utility>

// A main window for tests, operated through its widgets. The widgets are found by their names.
namespace handwheel::test {

#ifdef __SANITIZE_ADDRESS__
constexpr int kPatienceMs = 120000;  // all work takes several times as long with the sanitizer
#else
constexpr int kPatienceMs = 20000;
#endif

constexpr QSize kUsualWindow{1280, 800};
// A window in which less has to be drawn, for tests that do not depend on its size. The window becomes as large as its
// layout needs.
constexpr QSize kSmallWindow{700, 420};

class WindowDriver {
 public:
  explicit WindowDriver(std::vector<KindRegistration> kinds = builtInKinds(), MainWindow::Drivers drivers = {},
                        const QSize& size = kUsualWindow)
      : m_kinds(std::move(kinds)), m_window(m_workers, m_kinds.set, std::move(drivers)) {
    m_window.resize(size);
    m_window.show();
    if (!QTest::qWaitForWindowExposed(&m_window)) qFatal("the window does not appear");
  }
  explicit WindowDriver(const QSize& size) : WindowDriver(builtInKinds(), {}, size) {}
  ~WindowDriver() {
    release();
    m_workers.waitForDone();
  }

  MainWindow& window() { return m_window; }

  template <class Widget>
  Widget* find(const char* name) {
    auto* widget = m_window.findChild<Widget*>(QString::fromLatin1(name));
    if (!widget) qFatal("there is no %s", name);
    return widget;
  }
  void click(const char* name) {
    auto* button = find<QAbstractButton>(name);
    if (!QTest::qWaitFor([button] { return button->isVisible() && button->isEnabled(); }, kPatienceMs)) {
      qFatal("%s cannot be clicked", name);
    }
    QTest::mouseClick(button, Qt::LeftButton);
  }
  // Triggers the entry of a menu that has this name.
  void choose(const char* name) {
    for (const QMenu* menu : m_window.findChildren<QMenu*>()) {
      for (QAction* action : menu->actions()) {
        if (action->objectName() == QLatin1String(name)) return action->trigger();
      }
    }
    qFatal("no menu has %s", name);
  }
  // Types a value into the field of a property and accepts it.
  void edit(const char* property, const QString& value) {
    auto* row = find<QWidget>((QByteArray("property/") + property).constData());
    auto* line = row->findChild<QLineEdit*>();
    if (!line) qFatal("%s cannot be edited", property);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, value);
    QTest::keyClick(line, Qt::Key_Return);
  }
  QString text(const char* name) { return find<QLabel>(name)->text(); }

  QString tip(const char* name) { return find<QWidget>(name)->toolTip(); }

  // Uses as many threads as the program.
  void useAllThreads() { m_workers.setMaxThreadCount(kJobThreads); }
  // Occupies the only worker thread, so that no job starts before release().
  void hold() {
    m_workers.setMaxThreadCount(1);
    m_workers.start([this] { m_gate.acquire(); });
    ++m_held;
  }
  void release() { m_gate.release(std::exchange(m_held, 0)); }

  // Waits until all started jobs have done their work, without telling the window.
  void finishJobs() { m_workers.waitForDone(); }

  bool settle() {
    return QTest::qWaitFor([this] { return m_window.isSettled(); }, kPatienceMs);
  }
  bool open(const QString& path) {
    m_window.openPaths({path});
    return settle();
  }
  int tabs() { return find<QTabBar>("documentTabBar")->count(); }

  const DefectModel& defects() { return *qobject_cast<DefectModel*>(find<QTreeView>("defectList")->model()); }
  int count(DefectKind kind) { return defects().rowCount(defects().groupIndex(kind)); }
  void clickDefect(DefectKind kind, int row) {
    auto* list = find<QTreeView>("defectList");
    const QModelIndex index = defects().index(row, 0, defects().groupIndex(kind));
    list->scrollTo(index);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(index).center());
  }

  // Enters a name into a file dialog that is open or about to open, and accepts it.
  bool enterFileName(const char* dialogName, const QString& path) {
    QFileDialog* dialog = nullptr;
    const auto appears = [&] {
      dialog = m_window.findChild<QFileDialog*>(QString::fromLatin1(dialogName));
      return dialog && dialog->isVisible();
    };
    if (!QTest::qWaitFor(appears, kPatienceMs)) return false;
    // The suggested file may be selected by now, and would take precedence over the name.
    dialog->findChild<QAbstractItemView*>(QStringLiteral("listView"))->clearSelection();
    dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
    QMetaObject::invokeMethod(dialog, "accept");
    return QTest::qWaitFor([&] { return !m_window.findChild<QFileDialog*>(QString::fromLatin1(dialogName)); });
  }

 private:
  QSemaphore m_gate;
  int m_held = 0;
  QThreadPool m_workers;
  BuiltInKinds m_kinds;
  MainWindow m_window;
};

}  // namespace handwheel::test
