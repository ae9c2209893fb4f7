// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "StlFiles.h"
#include "WindowDriver.h"
#include "controls/ShortcutModel.h"

#include <QComboBox>
#include <QDialog>
#include <QKeySequenceEdit>
#include <QPushButton>

// Test fixtures for the keys of tools. Keys are changed in the preferences, and pressed in the view while a brush
// selects faces.
namespace handwheel::test {

inline constexpr const char* kSmaller = "tool/select/smaller";

// The page of keys in the preferences, operated through its widgets.
class KeyPage {
 public:
  explicit KeyPage(WindowDriver& driver) : m_driver(driver) {
    driver.choose("preferences");
    m_list = driver.find<QTreeView>("shortcutList");
  }
  ~KeyPage() {
    m_driver.find<QDialog>("preferences")->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

  const QAbstractItemModel& rows() const { return *m_list->model(); }
  QModelIndex rowOf(const QString& id) const {
    for (int row = 0; row < rows().rowCount(); ++row) {
      if (rows().index(row, 0).data(ShortcutModel::IdRole).toString() == id) return rows().index(row, 0);
    }
    return {};
  }
  void choose(const QString& id) {
    m_driver.find<QLineEdit>("shortcutSearch")->clear();
    if (!rowOf(id).isValid()) qFatal("no row of %s", qPrintable(id));
    m_list->setCurrentIndex(rowOf(id));
  }
  void press(const QString& id, int key, Qt::KeyboardModifiers modifiers = {}) {
    choose(id);
    auto* keys = m_driver.find<QKeySequenceEdit>("shortcutKeys");
    keys->setFocus();
    QTest::keyClick(keys, Qt::Key(key), modifiers);
    emit keys->editingFinished();  // the editor emits this signal after a pause
  }
  QString shownKeys(const QString& id) const {
    return rowOf(id).siblingAtColumn(ShortcutModel::Keys).data().toString();
  }
  QStringList conflicts(const QString& id) const { return rowOf(id).data(ShortcutModel::ConflictRole).toStringList(); }
  QString status() const { return m_driver.text("shortcutStatus"); }
  void useFile(const char* button, const char* dialogName, const QString& path) {
    m_driver.click(button);
    auto* dialog = m_driver.find<QFileDialog>(dialogName);
    emit dialog->fileSelected(path);
    delete dialog;
  }

 private:
  WindowDriver& m_driver;
  QTreeView* m_list;
};

class BrushFixture {
 public:
  BrushFixture() {
    const QString path = m_folder.filePath(QStringLiteral("hole.stl"));
    writeStl(path, torusWithHole());
    if (!driver.open(path)) qFatal("the file does not open");
    driver.find<QAction>("selectTool")->trigger();
    auto* mode = driver.find<QWidget>("toolDock")->findChild<QWidget*>("property/mode")->findChild<QComboBox*>();
    mode->setCurrentIndex(mode->findText("Brush", Qt::MatchFixedString));
    emit mode->activated(mode->currentIndex());
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

  double radius() {
    const auto* row = driver.find<QWidget>("toolDock")->findChild<QWidget*>("property/brush_pixels");
    return row->findChild<QLineEdit*>()->text().toDouble();
  }
  // Presses a key in the view. The window must be active, as otherwise the keys of menus do not work.
  void press(int key, Qt::KeyboardModifiers modifiers = {}) {
    driver.window().activateWindow();
    if (!QTest::qWaitForWindowActive(&driver.window())) qFatal("the window does not become active");
    auto* view = driver.find<Viewport>("viewport");
    view->setFocus();
    QTest::keyClick(view, Qt::Key(key), modifiers);
  }
  bool hints(const QString& hint) { return driver.find<QWidget>("hintBar")->accessibleName().contains(hint); }

  WindowDriver driver;

 private:
  QTemporaryDir m_folder;
};

}  // namespace handwheel::test
