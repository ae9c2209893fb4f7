// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/ProximityScenarios.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <QPointer>

class QComboBox;
class QDockWidget;
class QLabel;
class QPushButton;
class QTableWidget;

namespace handwheel {

class CellCollisions;
class PropertyList;

// The dock “Distance queries”, which measures the distance queries of a robot. It is the robot that is planned for. The
// dock shows the cost of each query (ProximityCosts) and the scenario in which the robot is. A job measures them on
// demand. The functions must be called on the window thread.
class ProximityDock : public QObject {
  Q_OBJECT

 public:
  ProximityDock(const WindowContext& parts, CellCollisions& collisions, QObject* parent);

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);

 private:
  enum class State { Idle, Waiting, Running };  // Waiting: for the cell to be prepared

  void makeDock();
  void open(bool isOpen);
  void measure();
  void start();
  void cancel();
  void take(const MeasuredScenario& measured);
  void setState(State state);
  void showCosts(const ProximityCosts* costs);
  void showTolerance();
  QString textOf(const MeasuredScenario& measured) const;

  WindowContext m_parts;
  CellCollisions& m_collisions;
  QAction m_toggle;
  DocumentTab* m_document = nullptr;
  State m_state = State::Idle;
  ProximityRequest m_request;
  bool m_isOutdated = false;  // True if the cell was changed since the measurement
  QString m_measured;         // The result as text; empty: none
  QPointer<QDockWidget> m_dock;
  QPointer<QComboBox> m_scenario;
  QPointer<PropertyList> m_tolerance;
  QPointer<QPushButton> m_measure, m_cancel;
  QPointer<QLabel> m_text;
  QPointer<QTableWidget> m_table;
};

}  // namespace handwheel
