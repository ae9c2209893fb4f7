// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../WindowDriver.h"
#include "controls/program/ProgramEditor.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/workpiece/program/ProgramSession.h"

#include <QAbstractButton>
#include <QAction>
#include <QListWidget>
#include <QMessageBox>
#include <QTest>

namespace handwheel::test {

// A window with a new workpiece and the dock of programs.
struct ProgramWindow {
  WindowDriver driver{kSmallWindow};

  bool begin() {
    driver.choose("newWorkpiece");
    return driver.settle() && openDock();
  }
  bool openDock() {
    if (!driver.find<QAction>("programDockToggle")->isChecked()) driver.choose("programDockToggle");
    return driver.settle() && QTest::qWaitFor([this] { return editor().isVisible(); }, kPatienceMs);
  }
  // Closes the dock, all documents without asking, and all messages, so that the next test can begin.
  void clear() {
    auto* const tabs = driver.find<DocumentTabs>("tabRow");
    auto* const toggle = driver.find<QAction>("programDockToggle");
    if (!tabs->all().empty() && !toggle->isChecked()) toggle->trigger();
    if (toggle->isChecked()) toggle->trigger();
    while (!tabs->all().empty()) tabs->close(tabs->all().back().get());
    auto* const message = driver.find<QAbstractButton>("messageClose");
    while (message->isVisible()) message->click();
    if (!driver.settle()) qFatal("the window does not settle");
  }
  WorkpieceDocument& document() {
    return static_cast<WorkpieceDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
  }
  ProgramEditor& editor() { return *driver.find<ProgramEditor>("programEditor"); }
  ProgramSession& session() { return *driver.window().findChild<ProgramSession*>(); }
  QListWidget& findings() { return *driver.find<QListWidget>("programFindings"); }
  // Pastes the text, as a person does with a text of several lines.
  void write(const char* text) {
    editor().selectAll();
    editor().insertPlainText(QString::fromLatin1(text));
  }
  bool run(const char* text) {
    write(text);
    driver.click("programRun");
    return driver.settle();
  }
  void clickFinding(int row) {
    QListWidget& list = findings();
    list.scrollToItem(list.item(row));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(row)).center());
  }
  // Answers the question before closing. Returns false if it does not come.
  bool answer(QMessageBox::StandardButton button) {
    QMessageBox* box = nullptr;
    const auto appears = [&] {
      box = driver.window().findChild<QMessageBox*>(QStringLiteral("closePrompt"));
      return box && box->isVisible();
    };
    if (!QTest::qWaitFor(appears, kPatienceMs)) return false;
    box->button(button)->click();
    return QTest::qWaitFor([&] { return !driver.window().findChild<QMessageBox*>(QStringLiteral("closePrompt")); });
  }
};

}  // namespace handwheel::test
