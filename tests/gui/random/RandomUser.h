// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/documents/DocumentTab.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTemporaryDir>
#include <QTimer>
#include <functional>
#include <map>
#include <random>

class QAbstractButton;
class QDialog;
class QFileDialog;
class QLineEdit;
class QMessageBox;

namespace handwheel {
class DocumentKinds;
class DocumentTabs;
class MainWindow;
}  // namespace handwheel

namespace handwheel::test {

// Operates the window at random, reproducibly from a seed. It presses keys, clicks, draws strokes, runs commands,
// opens, shows, saves and closes documents, and cancels jobs. A seed gives the same actions as long as jobs end in the
// same order. It also checks that no document is lost: one with unsaved changes may close only after its prompt was
// answered with "discard", and any other only by a command that closes.
class RandomUser : public QObject {
  Q_OBJECT

 public:
  // Creates files to open in a folder of its own, where the user also saves.
  RandomUser(MainWindow& window, const DocumentKinds& kinds, std::uint32_t seed);

  // Does one random action, and waits for its effects for some milliseconds. The action is written to the standard
  // output before it is done, so that the last lines show the cause of a crash.
  void act();
  // Returns a sentence for each thing that should not have happened.
  const QStringList& problems() const { return m_problems; }
  // Undoes all steps in every document and compares it with its state when it was opened. alive: called repeatedly
  // while it waits for jobs.
  void undoEverything(const std::function<void()>& alive);

 private:
  struct Opened {
    std::string bytes;  // bytes of its container
    int index = 0;      // index in its history when it was opened: 1 if opening reversed faces
    QString step = {};  // text of the step before that index; it is gone when another one took its place after an undo
  };

  int upTo(int count) { return std::uniform_int_distribution<int>(0, count - 1)(m_random); }
  bool oneIn(int count) { return upTo(count) == 0; }
  static void note(const QString& what);
  void makeFiles();
  QWidget* target() const;  // the receiver of keys

  bool answerDialogs();
  void answer(QDialog& dialog);
  void answer(QMessageBox& prompt);
  void answer(QFileDialog& dialog);
  void openFile();
  void pressKey();
  void strokeInView();
  void clickButton();
  void clickRow();
  void runCommand();
  void runAction();
  void editField();
  void enter(QLineEdit& line);
  void switchDocument();
  void cancelJob();
  void searchCommand();
  void watchClosing(DocumentTab* document);
  void keepOpened(const DocumentTab& open);
  void check();
  void checkFile(const DocumentTab& saved, const std::string& now);
  // Returns false if the history does not lead to the opened state any more.
  bool goToOpened(const DocumentTab& of) const;
  void report(const DocumentTab& of, const QString& when, const std::string& wanted, const std::string& is);

  MainWindow& m_window;
  const DocumentKinds& m_kinds;
  DocumentTabs& m_tabs;
  std::mt19937 m_random;
  QTimer m_menus;  // runs during an action, and answers the menus that the action waits for
  QTemporaryDir m_folder;
  QStringList m_files;
  QStringList m_problems;
  std::map<const DocumentTab*, Opened> m_opened;  // each document in the state in which it was opened
  bool m_mayClose = false;                        // the present action is a command that closes
  bool m_mayDiscard = false;  // a prompt was answered with "discard" and its document has not closed yet
};

}  // namespace handwheel::test
