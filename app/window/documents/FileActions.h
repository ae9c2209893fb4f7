// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/documents/ClosePrompt.h"
#include "window/documents/FileLoader.h"
#include "window/documents/FileSaver.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <functional>
#include <map>
#include <optional>
#include <vector>

class QMenu;

namespace handwheel {

// The actions of the File menu and their dialogs.
class FileActions : public QObject {
  Q_OBJECT

 public:
  FileActions(QWidget* window, const DocumentKinds& kinds, const KindUis& uis, DocumentTabs& tabs, JobRunner& jobs,
              RecentFiles& recent, LogModel& log);

  QAction* open() { return &m_open; }
  QList<QAction*> newActions() const { return startActions(true); }
  QList<QAction*> sampleActions() const { return startActions(false); }
  QAction* save() { return &m_save; }
  QAction* saveAs() { return &m_saveAs; }
  QAction* closeTab() { return &m_close; }
  QList<QAction*> tabSteps() { return {&m_nextTab, &m_previousTab}; }
  QMenu* recentMenu() { return m_recentMenu; }

  FileLoader& loader() { return m_loader; }

  // Adds the start actions of a kind of document, in the order of the calls.
  void add(const std::string& kind, KindUi& ui);
  std::vector<StartTile> tiles() const;
  // Runs the start action of the tile with this name.
  void begin(const QString& tile);

  QString iconNameFor(const QString& path) const;  // name of the icon for a file
  void openPaths(const QStringList& paths);
  // Closes a document; if it is modified the user is asked first. then: the function that is called when the document
  // is closed. A second request while the user is being asked, or the document is being saved, waits for the same
  // answer.
  void requestClose(DocumentTab* document, std::function<void()> then = {});
  // Asks once about all modified documents. Closes all documents when no file is being written, unless the user cancels
  // or saving fails. then: the function that is called when all are closed.
  void requestCloseAll(std::function<void()> then);

 signals:
  void aboutToClose();  // a document is going to be closed, unless the user cancels
  void message(const handwheel::Message& message);
  void saved(const handwheel::Document* document, const QString& topic);  // see FileSaver::succeeded()

 private:
  QList<QAction*> startActions(bool isNew) const;
  void askForFiles();
  bool offerBeside(const QString& path);
  void saveCurrent();
  // Saves a document; asks for a name if one is needed. ended: as for FileSaver::save(); it is also called if no name
  // was chosen.
  void saveOrAsk(DocumentTab* document, std::function<void(bool)> ended);
  void askForName(DocumentTab* document, std::function<void(bool)> ended, bool asContainer = false);
  void offerAnotherName(DocumentTab* document, Message message);
  void offerContainer(DocumentTab* document, Message message);
  static bool wouldLose(const DocumentTab& document);
  // Asks what to do with the changes that a document would lose. decided: the function that is called with the result:
  // false if the user cancels or saving fails.
  void decide(DocumentTab* document, std::function<void(bool)> decided);
  // Asks one of the two questions about a document, unless the user has answered it for all documents at once.
  void ask(const DocumentTab& document, const QString& name, std::function<void(CloseAnswer)> then);
  std::optional<CloseAnswer> givenAnswer(const DocumentTab& document) const;
  void endClosing(DocumentTab* document, bool close);
  // Asks about all modified documents at once, if there are several.
  void askAboutAll(std::function<void()> then);
  // Asks about the next modified document. decided: the revision of each document when the user answered the question
  // about it. If a document changes later, the user is asked again.
  void decideNext(std::map<const DocumentTab*, std::uint64_t> decided, std::function<void()> then);
  void followDocument();
  void fillRecentMenu();
  bool needsNewName(const DocumentTab& document) const;

  QWidget* m_window;
  const DocumentKinds& m_kinds;
  const KindUis& m_uis;
  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  RecentFiles& m_recent;
  FileLoader m_loader;
  FileSaver m_saver;
  // Documents that the user is being asked about or that are being saved before closing, with the functions to call
  // when they are closed.
  std::map<const DocumentTab*, std::vector<std::function<void()>>> m_closing;
  // The answers that were given for all documents at once, with the revisions of the documents at that time.
  std::map<const DocumentTab*, std::pair<CloseAnswer, std::uint64_t>> m_answers;
  bool m_isAskingAboutAll = false;
  QMetaObject::Connection m_afterSaving;  // connection that closes all documents when no file is being written
  QAction m_open;
  std::vector<std::pair<StartAction, QAction*>> m_startActions;
  QAction m_save;
  QAction m_saveAs;
  QAction m_close;
  QAction m_nextTab;
  QAction m_previousTab;
  QMenu* m_recentMenu;
};

}  // namespace handwheel
