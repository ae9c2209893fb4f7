// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

class QFrame;
class QLabel;
class QListWidget;
class QPushButton;

namespace handwheel {

// A step of a lesson, in the words of its author.
struct LessonStep {
  enum class State { Open, Done, Failed };
  QString title;
  QString text;            // instructions; plain text
  QStringList hints = {};  // shown one after another, on request
  State state = State::Open;
  bool byHand = false;  // true: the user marks the step as done; false: the program checks it
  int shownHints = 0;   // number of hints that were already requested
};

// A panel that leads through a lesson, with hints on demand and the time. The shown step is the first one that is not
// done, until the user chooses another one. The panel only displays: the owner of the lesson sets the states.
class LessonPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LessonPanel(QWidget* parent = nullptr);

  // Shows a lesson that is begun or continued.
  void setLesson(const QString& title, std::vector<LessonStep> steps);
  void setStepState(std::size_t step, LessonStep::State state);
  // Sets the time since the lesson began and the allowed time, s. An allowed time of 0 means no limit. Negative times
  // count as zero.
  void setTime(double elapsed, double allowed);

  std::size_t steps() const { return m_steps.size(); }
  int shownStep() const { return m_shown; }  // index of the shown step; -1: none
  bool isHintShown() const;

 signals:
  void stepShown(int step);
  // Emitted when the user requests one more hint. count: the number of hints shown for the step.
  void hintShown(int step, int count);
  void stepDone(int step);  // the user has finished a step that is done by hand

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showStep(int step);
  void showStates();
  int current() const;
  void showHint();

  std::vector<LessonStep> m_steps;
  int m_shown = -1;
  QLabel* m_title;
  QLabel* m_progress;
  QLabel* m_time;
  QListWidget* m_list;
  QLabel* m_text;
  QFrame* m_hintCard;
  QLabel* m_hint;
  QPushButton* m_askHint;
  QPushButton* m_done;
};

// Formats a time as "4:05" or "1:04:05"; whole seconds, rounded down.
QString clockText(double seconds);

}  // namespace handwheel
