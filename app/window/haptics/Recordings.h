// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/StoredRecording.h"
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

// Manages the haptic recordings of the current document. It provides the commands for recording, playing, writing as
// CSV, renaming and deleting. A recording is added as an undo step to the document in which it was started. Must be
// used on the window thread.
class Recordings : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    QWidget* window;  // parent of the dialogs
    HapticSession& session;
    JobRunner& jobs;
    LogModel& log;
    ServoClock& clock;
  };
  explicit Recordings(const Parts& parts, QObject* parent = nullptr);

  // Sets the current document; null: no document. A running recording for another document is ended.
  void setDocument(Document* document);
  // Ends a running recording and adds it to its document.
  void finish();

  // Sets the name of the active tool (its recordedName()); empty: no tool. A change of the tool is stored in the
  // running recording.
  void noteTool(const std::string& name);

  std::vector<StoredRecording> all() const;  // recordings of the current document
  const StoredRecording* chosen() const;     // null: no recording is chosen
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
  void changed();                          // the list, or the chosen recording, has changed
  void nameRequested(const QString& key);  // the user is to edit the name
  void message(const handwheel::Message& message);

 private:
  void prepareActions();
  void markTool();
  void keep(const Recording& ticks, const QString& device, double forceLimit);
  void commit(const QString& text, std::vector<StoredRecording> recordings);
  void togglePlaying();
  void removeChosen();
  void askForFile();
  void writeCsv(const StoredRecording& recording, const QString& path);
  void follow();
  void enableActions();
  void nameActions(bool isRecording, bool isPlaying);

  Parts m_parts;
  Playback m_playback;
  QPointer<Document> m_document;
  QPointer<Document> m_recorded;  // document in which the recording was started
  std::string m_chosen;           // key of the chosen recording
  std::string m_tool;             // recordedName() of the active tool
  bool m_isNamedStop = false;     // m_record is labelled "Stop recording"
  bool m_isNamedPause = false;
  QAction m_record, m_play, m_leave, m_export, m_rename, m_remove;
};

}  // namespace handwheel
