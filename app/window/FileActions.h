// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/FileLoader.h"
#include "window/FileSaver.h"
#include "window/KindUi.h"

#include <QAction>
#include <functional>
#include <map>
#include <vector>

class QMenu;

namespace handwheel {

// The File menu: what can be done with files, and the dialogs that it takes.
class FileActions : public QObject {
  Q_OBJECT

 public:
  FileActions(QWidget* window, const DocumentKinds& kinds, const KindUis& uis, DocumentTabs& tabs, JobRunner& jobs,
              RecentFiles& recent, LogModel& log);

  QAction* open() { return &m_open; }
  // New documents, then samples.
  QList<QAction*> beginnings() const;
  QAction* save() { return &m_save; }
  QAction* saveAs() { return &m_saveAs; }
  QAction* closeTab() { return &m_close; }
  QList<QAction*> tabSteps() { return {&m_nextTab, &m_previousTab}; }
  QMenu* recentMenu() { return m_recentMenu; }

  FileLoader& loader() { return m_loader; }

  // The ways to begin with a document of this kind; in the order of the calls.
  void add(const std::string& kind, const KindUi& ui);
  std::vector<StartTile> tiles() const;
  // As one of them says.
  void begin(const QString& tile);

  QString iconNameFor(const QString& path) const;  // of a drawing
  void openPaths(const QStringList& paths);
  // Closes a document; when it is modified the user is asked first. then: called once it is closed. While the user is
  // asked, or it is saved, a second wish to close it waits for the same answer.
  void requestClose(OpenDocument* document, std::function<void()> then = {});
  // Closes all, asking as needed. then: called when none is left.
  void requestCloseAll(std::function<void()> then);

 signals:
  void aboutToClose();  // a document, if nothing is to be saved or the user does not mind
  void message(const handwheel::Message& message);

 private:
  void askForFiles();
  void saveCurrent();
  // ended: as of FileSaver::save(); also when no name was given.
  void saveOrAsk(OpenDocument* document, std::function<void(bool)> ended);
  void askForName(OpenDocument* document, std::function<void(bool)> ended, bool asContainer = false);
  void offerAnotherName(OpenDocument* document, Message message);
  void offerContainer(OpenDocument* document, Message message);
  void endClosing(OpenDocument* document, bool close);
  void followDocument();
  void fillRecentMenu();
  bool needsNewName(const OpenDocument& document) const;

  QWidget* m_window;
  const DocumentKinds& m_kinds;
  DocumentTabs& m_tabs;
  RecentFiles& m_recent;
  FileLoader m_loader;
  FileSaver m_saver;
  // Those that are asked about or saved in order to be closed, and what follows when they are.
  std::map<const OpenDocument*, std::vector<std::function<void()>>> m_closing;
  QAction m_open;
  std::vector<std::pair<Beginning, QAction*>> m_beginnings;
  QAction m_save;
  QAction m_saveAs;
  QAction m_close;
  QAction m_nextTab;
  QAction m_previousTab;
  QMenu* m_recentMenu;
};

}  // namespace handwheel
