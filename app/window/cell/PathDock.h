// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "planning/PathTiming.h"
#include "tools/cell/CellContacts.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <QPointer>
#include <memory>
#include <optional>
#include <string>
#include <utility>

class QDockWidget;
class QLabel;

namespace handwheel {

class CellPaths;
class TimeLinePanel;
struct CheckedPath;
struct TimeLineRecording;

// The dock “Path”, which plays a path of the robot on a time line. The time line shows clearance, manipulability and
// margin to the limits as curves, and collisions as marks. While the dock is open, the view shows the robot at the
// current time. The functions must be called on the window thread.
class PathDock : public QObject {
  Q_OBJECT

 public:
  PathDock(const WindowContext& parts, CellPaths& paths, QObject* parent);

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);
  void close() { open(false); }

 signals:
  // Emitted when the replay shows other parts, which hide all others in the view, with their collisions. parts: null if
  // it shows none.
  void partsShown(const std::shared_ptr<const handwheel::DisplayModel>& parts,
                  const std::vector<handwheel::CellCollision>& collisions);

 private:
  void makeDock();
  JointValues standing() const;
  void takeChange();
  void open(bool isOpen);
  void prepare();
  void showNothing();
  void show(double seconds);
  QString toolText(const CellScene& scene, const ArmValues& values) const;
  void goToCollision(const std::string& path, std::size_t number);
  void goToWanted();
  TimeLineRecording recordingOf(const CheckedPath& checked) const;
  double timeOf(std::size_t motion, double share) const;

  WindowContext m_parts;
  CellPaths& m_paths;
  QAction m_toggle;
  bool m_isOpen = false;
  DocumentTab* m_document = nullptr;
  JointValues m_standing;   // Joint values of the document when the dock was opened
  std::string m_countedIn;  // The frame of the displayed coordinates; empty: the cell
  QPointer<QDockWidget> m_dock;
  QPointer<QLabel> m_text;
  QPointer<TimeLinePanel> m_line;
  std::shared_ptr<const CheckedPath> m_shown;
  std::unique_ptr<TimedPath> m_timed;  // Times of the path m_shown
  // A collision to show once its path is verified: the name of the path, and the index of the collision in
  // stretchesOf().
  std::optional<std::pair<std::string, std::size_t>> m_wanted;
};

}  // namespace handwheel
