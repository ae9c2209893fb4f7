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
  // Returns the text of a read-only field of the panel; empty if it is not listed.
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
  // Plans between the first configuration and the last.
  void planPath() {
    choose("planPath");
    auto* dialog = find<QDialog>("planDialog");
    QTest::qWait(50);
    auto* now = dialog->findChild<QPushButton*>(QStringLiteral("planNow"));
    QTest::mouseClick(now, Qt::LeftButton);
  }
};

}  // namespace handwheel::test
