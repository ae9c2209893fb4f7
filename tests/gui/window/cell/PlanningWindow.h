// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CellWindow.h"

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

namespace handwheel::test {

// A window in which a path is planned.
class PlanningWindow : public CellWindow {
 public:
  QTreeWidget* tree() { return find<QTreeWidget>("planTree"); }
  QTreeWidgetItem* configurations() { return tree()->topLevelItem(0); }
  QTreeWidgetItem* paths() { return tree()->topLevelItem(1); }

  void clickItem(QTreeWidgetItem* item) {
    tree()->scrollToItem(item);
    QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {}, tree()->visualItemRect(item).center());
  }
  // Returns the text of a read-only field of the panel. The text is empty if the panel does not list the field.
  QString shown(const char* property) {
    const QString name = QStringLiteral("property/") + QString::fromLatin1(property);
    const auto* row = find<QDockWidget>("kindDock")->findChild<QWidget*>(name);
    const auto* value = row ? row->findChild<QLabel*>(QStringLiteral("propertyValue")) : nullptr;
    return value ? value->text() : QString();
  }
  void storeAt(const char* joint, const QString& value) {
    edit(joint, value);
    choose("storeConfiguration");
  }
  // Plans a path from the first configuration to the last.
  void planPath() {
    choose("planPath");
    auto* dialog = find<QDialog>("planDialog");
    QTest::qWait(50);
    auto* now = dialog->findChild<QPushButton*>(QStringLiteral("planNow"));
    QTest::mouseClick(now, Qt::LeftButton);
  }
  QString remark(int path) { return paths()->childCount() > path ? paths()->child(path)->text(1) : QString(); }
  bool becomes(int path, const char* remarked) {
    return QTest::qWaitFor([&] { return remark(path).contains(QLatin1String(remarked)); }, kPatienceMs);
  }
  // Also closes the time line.
  void takeBack(const QString& step) {
    const auto* dock = window().findChild<QDockWidget*>(QStringLiteral("pathDock"));
    if (dock && !dock->isHidden()) choose("pathDockToggle");
    CellWindow::takeBack(step);
  }
};

// A window with verified paths between two configurations. The last path is selected. The view is small.
template <int Paths>
class PlannedWindow : public PlanningWindow {
 public:
  PlannedWindow() {
    setViewSmall(true);
    storeAt("joint.joint_1", "60");
    storeAt("joint.joint_1", "-60");
    for (int path = 0; path < Paths; ++path) {
      if (!settle()) qFatal("the cell is not prepared");
      planPath();
      if (!becomes(path, "free")) qFatal("no path is planned");
    }
  }
  void takeBack(const QString& step) {
    PlanningWindow::takeBack(step);
    tree()->setCurrentItem(paths()->child(Paths - 1));
    // Only a few results of verification are stored per path, so the result for this state may be lost.
    if (!remark(0).contains("free")) choose("verifyAllPaths");
    for (int path = 0; path < Paths; ++path) {
      if (!becomes(path, "free")) qFatal("a path is not verified");
    }
    if (!settle()) qFatal("the cell is not prepared");
    closeMessages();
  }
};

}  // namespace handwheel::test
