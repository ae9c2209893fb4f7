// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // moc cannot read <numbers>, which Units.h includes, without this before it

#include "document/workpiece/ProgramTrial.h"
#include "document/workpiece/playback/PlayedPart.h"
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
struct LeftOutPass;

// The display of a program run in the view.
struct ProgramPicture {
  PathLayer::Lines lines;
  std::vector<std::vector<Vec3>> tool;       // outlines of the tool
  std::shared_ptr<const DisplayModel> part;  // the part cut up to the current position; null: the part of the document
};

// The program of one document: its text, file, runs, and the current position. It is used on the window thread; runs
// are jobs on copies of their input.
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

  // Returns true if the view shows the simulated cut of a run, which the document does not have.
  bool isSimulated() const { return m_trial != nullptr; }
  bool isCuttable() const;
  QString cuttingTip() const;  // the effect of cutting, or the reason why it is impossible
  // Cuts the work with the program that was run. If there are collisions, the user is asked first.
  void cut();
  // Ends the display of the run, so that the view shows the part as it is in the document; the text stays.
  void leave();

  // Reads a program, which replaces the text. Undo in the editor restores the former text.
  void read(const QString& path);
  void save(std::function<void(bool isSaved)> ended);

 signals:
  void pictureChanged();
  void message(const handwheel::Message& message);

 private:
  const WorkpieceDocument& workpiece() const;
  ProgramSetup setup() const;
  void prepareActions();
  bool isToBeDoneByHand() const;  // the exercise requires this; O(size of its description)
  // Returns the nose radius of the first tool of the exercise that turns the outside, mm; none: there is no exercise,
  // or no such tool.
  std::optional<double> noseOfExercise() const;
  bool isRefused();  // shows a message if the work is to be done by hand
  void connectPanel();
  // The text, or its interpretation, has changed: results of checks and runs are dropped.
  void textChanged();
  void documentChanged();
  void forgetRun();
  void check();
  void checked(const std::vector<Error>& problems, bool isJumping);  // isJumping: selects the first problem
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
  void warnOfLeftOut(const std::vector<LeftOutPass>& passes);
  void askForCycles();
  void askForTools();
  void setTools(ProgramTools tools, bool isOwn);
  void takeStoredTools();
  void storeTools(const ProgramTools& chosen);
  void dialectChanged();
  void writeCycles(const std::vector<double>& numbers);
  // Warns of the material that cycles leave on the target, unless it is negligible.
  void warnOfRest(const CycleRest& rest, const TargetProfile& target, double drill);
  void offer(const std::string& text, ProgramTools tools);
  void showName();
  void fail(const QString& title, const Error& error);

  // Display of a run.
  void goTo(const ProgramPosition& position);
  void showPosition();
  void showPart();
  void choose(const ProgramFinding& finding);
  std::vector<ProgramFinding> findingsOf(const ProgramTrial& trial) const;
  QString summaryOf(const ProgramTrial& trial) const;

  WindowContext m_parts;
  DocumentTab& m_document;
  QAction m_open, m_save, m_saveAs, m_fromPasses, m_cycles;
  QPointer<ProgramPanel> m_panel;
  ProgramTools m_tools;  // the tool table; other tools have the nose radius that the panel shows
  std::shared_ptr<const ProgramTools> m_storedTools;  // tool table of the document when it was last read
  bool m_isByHand = false;                            // the exercise allows no programs
  bool m_hasOwnTools = false;                         // the user made the table, so it is kept for the next text
  QString m_path;                                     // path of the file; empty: none yet
  ProgramFile m_file;
  std::uint64_t m_texts = 0;  // number of texts begun; a finished save sets m_path only if it is still the same
  JobRunner m_checks, m_runs, m_views, m_files;
  QString m_text;  // text after its last change
  QTimer m_pause;  // runs since the last change of the text; a check follows

  ProgramTrial::Pointer m_trial;  // null: the present text was not run
  WorkpieceSnapshot m_start;      // initial workpiece of the trial
  ProgramPosition m_position, m_shown;
  std::shared_ptr<PlayedPart> m_played;  // the shown part of the trial; used by one job at a time
  bool m_isShowing = false;              // a job is making the part of a position
  ProgramPicture m_picture;
};

}  // namespace handwheel
