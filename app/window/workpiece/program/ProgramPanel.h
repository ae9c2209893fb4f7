// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "machining/program/ProgramSetup.h"

#include <QWidget>
#include <optional>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace handwheel {

class ControlButton;
class NumberField;
class ProgramEditor;
class ProgramPlayer;

// An error, a collision or a note in the list below a program. A click on it selects its position in the text.
struct ProgramFinding {
  enum class Weight { Note, Warning, Error };
  Weight weight = Weight::Note;
  int line = 0;    // line of the program, from 1; 0: none
  int column = 0;  // column in the line, from 1; 0: the whole line
  QString text;
  std::optional<std::size_t> move;  // move of the tool path that ends at the finding
};

// A panel with the widgets of a program. They are the editor, the dialect and the nose radius, the buttons to run and
// cut, the findings, and the player. The panel makes no decisions. It must be used on the window thread.
class ProgramPanel : public QWidget {
  Q_OBJECT

 public:
  // The actions of the buttons above the editor.
  struct Actions {
    QAction *open, *save, *saveAs, *fromPasses, *cycles;
  };
  ProgramPanel(const Actions& actions, QWidget* parent = nullptr);

  ProgramEditor& editor() { return *m_editor; }
  ProgramPlayer& player() { return *m_player; }

  QString name() const;  // file name, with a mark if the text is not saved
  void setName(const QString& name);
  ProgramDialect dialect() const;
  void setDialect(ProgramDialect dialect);       // emits no signal
  void applyControl(ProgramSetup& setup) const;  // sets what the control reads as the user has chosen
  double nose() const;                           // mm
  void setNose(double mm);                       // emits no signal
  void setPost(const ProgramPost& post);         // emits no signal
  void setToolCount(std::size_t count);          // number of tools in the table

  // Sets the list of findings and the marks in the editor.
  void setFindings(std::vector<ProgramFinding> findings);
  void setSummary(const QString& text);
  // Shows whether a program is running, with its progress (0…1) and a button to cancel it.
  void setRunning(bool isRunning);
  void setProgress(double fraction);
  void setCuttable(bool isCuttable, const QString& why);

 signals:
  void dialectChanged();
  void noseChanged();
  void controlChanged();
  void postChosen(const handwheel::ProgramPost& post);
  void toolsRequested();
  void runRequested();
  void cancelRequested();
  void cutRequested();
  void findingChosen(const handwheel::ProgramFinding& finding);
  void dropped(const QString& path);
  void saveRequested();  // emitted when the key for saving is pressed in the editor

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeFileRow(const Actions& actions);
  QWidget* makeSetupRow();
  QWidget* makeRunRow();
  void chosen(int row);

  ProgramEditor* m_editor;
  ProgramPlayer* m_player;
  QLabel* m_name;
  QComboBox* m_dialect;
  ControlButton* m_control;
  NumberField* m_nose;
  QComboBox* m_post;
  QPushButton* m_tools;
  QPushButton* m_run;
  QPushButton* m_cancel;
  QPushButton* m_cut;
  QProgressBar* m_progress;
  QLabel* m_summary;
  QListWidget* m_list;
  std::vector<ProgramFinding> m_findings;
};

}  // namespace handwheel
