// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

#include "document/workpiece/ProgramTrial.h"
#include "viewport/path/PathLayer.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"
#include "window/workpiece/program/ProgramFile.h"
#include "window/workpiece/program/ProgramPanel.h"

#include <QAction>
#include <QPointer>
#include <QTimer>

namespace handwheel {

class TargetProfile;
class WorkpieceDocument;
struct CycleRest;

// What the view shows of a program that was run.
struct ProgramPicture {
  PathLayer::Lines lines;
  std::vector<std::vector<Vec3>> tool;       // outlines
  std::shared_ptr<const DisplayModel> part;  // as it is cut up to the line; null: as the document has it
};

// The program of one document: its text, file, runs, and the current position. Window thread; runs are jobs on what
// they were given.
class ProgramSession : public QObject {
  Q_OBJECT

 public:
  ProgramSession(const WindowContext& parts, DocumentTab& document, QObject* parent);
  ~ProgramSession() override;

  ProgramPanel* panel() { return m_panel; }
  const ProgramPicture& picture() const { return m_picture; }
  bool isSettled() const;
  bool isUnsaved() const;
  QString fileName() const;  // "shaft.ngc"

  // The view shows what a run would cut, and the document has not.
  bool isSimulated() const { return m_trial != nullptr; }
  bool isCuttable() const;
  QString cuttingTip() const;  // what cutting would do, or why it cannot
  // Cuts the work with the program that was run; with crashes only after they were read.
  void cut();
  // Shows the part as it is; the text stays.
  void leave();

  // Reads a program, and replaces the text by it, which the undo of the editor brings back.
  void read(const QString& path);
  void save(std::function<void(bool isSaved)> ended);

 signals:
  void pictureChanged();
  void message(const handwheel::Message& message);

 private:
  const WorkpieceDocument& workpiece() const;
  ProgramSetup setup() const;
  void prepareActions();
  bool isToBeDoneByHand() const;  // as the exercise wants it that this is work on; O(its description)
  // mm, of the first tool of the exercise that turns the outside; none: there is no exercise, or no such tool.
  std::optional<double> noseOfExercise() const;
  bool isRefused();  // as it is to be done by hand; says so
  void connectPanel();
  // The text is another one, or is understood otherwise: what was found of it is over.
  void textChanged();
  void documentChanged();
  void forgetRun();
  void check();
  void checked(const std::vector<Error>& problems, bool isJumping);  // to the first
  void run();
  void ran(ProgramTrial::Pointer trial, PathLayer::Lines lines, const std::vector<ProgramFinding>& limits);
  void askToCut();
  void cutAnyway(const ProgramTrial::Pointer& trial);
  void setText(const QString& text, ProgramTools tools);
  void askForFile();
  void taken(const QString& path, const ProgramFile& file);
  void askForName(std::function<void(bool)> ended);
  void write(const QString& path, std::function<void(bool)> ended);
  void askForPasses();
  void writePasses(double spindle);
  void askForCycles();
  void askForTools();
  void setTools(ProgramTools tools, bool isOwn);
  void takeStoredTools();
  void storeTools(const ProgramTools& chosen);
  void dialectChanged();
  void writeCycles(const std::vector<double>& numbers);
  // What cycles leave of the target; nothing where that is not worth telling.
  void warnOfRest(const CycleRest& rest, const TargetProfile& target, double drill);
  void offer(const std::string& text, ProgramTools tools);
  void showName();
  void fail(const QString& title, const Error& error);

  // Looking at a run.
  void goTo(const ProgramPosition& position);
  void showPlace();
  void showPart();
  void choose(const ProgramFinding& finding);
  std::vector<ProgramFinding> findingsOf(const ProgramTrial& trial) const;
  QString summaryOf(const ProgramTrial& trial) const;

  WindowContext m_parts;
  DocumentTab& m_document;
  QAction m_open, m_save, m_saveAs, m_fromPasses, m_cycles;
  QPointer<ProgramPanel> m_panel;
  ProgramTools m_tools;                               // the table; what is not in it has the nose of the panel
  std::shared_ptr<const ProgramTools> m_storedTools;  // of the document, as they were last
  bool m_isByHand = false;                            // the exercise allows no programs
  bool m_hasOwnTools = false;                         // the user made it, so that it is that of the next text, too
  QString m_path;                                     // of the file; empty: none yet
  ProgramFile m_file;
  std::uint64_t m_texts = 0;  // that were begun: a file that is saved is that of its text only
  JobRunner m_checks, m_runs, m_views, m_files;
  QString m_text;  // as it was last
  QTimer m_pause;  // since the last change of the text

  ProgramTrial::Pointer m_trial;  // null: the text was not run as it is
  WorkpieceSnapshot m_start;      // of the trial
  ProgramPosition m_position, m_shown;
  bool m_isShowing = false;  // a job makes the part of a place
  ProgramPicture m_picture;
};

}  // namespace handwheel
