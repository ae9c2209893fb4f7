// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/KeptRecording.h"
#include "panels/MessageBar.h"
#include "window/haptics/Playback.h"

#include <QAction>
#include <QObject>
#include <QPointer>

namespace handwheel {

class Document;
class HapticSession;
class JobRunner;
class LogModel;

// The recordings of the document in view, and the commands for them: recording, playing, writing as CSV, renaming,
// deleting. What is recorded goes into the document in which it began, as a step of its history. Window thread.
class Recordings : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    QWidget* window;  // of the dialogs
    HapticSession& session;
    JobRunner& jobs;
    LogModel& log;
    ServoClock& clock;
  };
  explicit Recordings(const Parts& parts, QObject* parent = nullptr);

  // The one in view from now on; null: none. What is being recorded in another ends.
  void setDocument(Document* document);
  // What is being recorded ends, and its document has it.
  void finish();

  // Which tool is in use, by its id; empty: none. A change of it stands in the recording.
  void noteTool(const std::string& id);

  std::vector<KeptRecording> all() const;  // of the document in view
  const KeptRecording* chosen() const;     // null: none
  void choose(const std::string& key);
  void rename(const std::string& key, const QString& name);
  Playback& playback() { return m_playback; }

  QAction* recordAction() { return &m_record; }
  QAction* playAction() { return &m_play; }
  QAction* leaveAction() { return &m_leave; }
  QAction* exportAction() { return &m_export; }
  QAction* renameAction() { return &m_rename; }
  QAction* removeAction() { return &m_remove; }

 signals:
  void changed();                       // the list, or which is chosen
  void nameWanted(const QString& key);  // the user is to be asked for another
  void message(const handwheel::Message& message);

 private:
  void prepareActions();
  void markTool();
  void keep(const Recording& ticks, const QString& device, double forceLimit);
  void commit(const QString& text, std::vector<KeptRecording> recordings);
  void togglePlaying();
  void removeChosen();
  void askForFile();
  void writeCsv(const KeptRecording& recording, const QString& path);
  void follow();
  void enableActions();
  void nameActions(bool isRecording, bool isPlaying);

  Parts m_parts;
  Playback m_playback;
  QPointer<Document> m_document;
  QPointer<Document> m_recorded;  // in which the recording began
  std::string m_chosen;           // key
  std::string m_tool;             // id
  bool m_isNamedStop = false;     // what the actions say
  bool m_isNamedPause = false;
  QAction m_record, m_play, m_leave, m_export, m_rename, m_remove;
};

}  // namespace handwheel
