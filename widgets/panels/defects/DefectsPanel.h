// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/defects/HoleSettings.h"

#include <QTimer>
#include <QWidget>
#include <set>

class QTreeView;

namespace handwheel {

class DefectCard;
class DefectDelegate;
class DefectModel;
class DefectList;
class StateCard;

// The actions that the panel shows as buttons.
struct DefectsPanelActions {
  QAction* fillAll;
  QAction* previous;
  QAction* next;
  QAction* fill;
  QAction* keepOpen;
  QAction* preview;
  QAction* thickenSheet;
  QAction* cutAndClose;
  QAction* fix;  // fixes the selected defects
};

// The panel with the defects of the current document. It shows the overall state, the list of defects by kind, and the
// settings for the selected hole. Selection and hovering are synchronised with the viewport.
class DefectsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DefectsPanel(const DefectsPanelActions& actions, QWidget* parent = nullptr);

  void setDefectList(DefectList* defectList);  // null: no document is open
  DefectModel* model() const { return m_model; }
  HoleSettings* settings() const { return m_settings; }

  // Shows a sentence on the expected effect of the offered fix. An empty text removes it.
  void showFixPreview(const QString& text);
  void setSelectedLoop(int loop);     // selects the row of a loop; -1: none
  void setHighlightedLoop(int loop);  // the loop under the cursor in the viewport

 signals:
  void loopSelected(int loop);
  void loopHovered(int loop);
  void defectActivated(const QModelIndex& index);  // emitted for a click; the camera is to move to the defect
  void defectChosen(const QModelIndex& index);     // emitted for a selected row or group; invalid: none

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void defectListChanged();
  void clicked(const QModelIndex& index);
  void currentChanged(const QModelIndex& index);
  void updateSettings();
  void showDefect();

  DefectModel* m_model;
  DefectDelegate* m_delegate;
  StateCard* m_state;
  QTreeView* m_list;
  HoleSettings* m_settings;
  DefectCard* m_card;
  QWidget* m_content;
  QWidget* m_empty;
  DefectList* m_defectList = nullptr;
  int m_selectedLoop = -1;
  bool m_following = false;  // the selection is being set by the program
  std::set<int> m_expanded;  // expanded kinds; lost at each model reset
  QTimer m_spinner;
};

}  // namespace handwheel
