// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingForceModel.h"
#include "window/kinds/KindUi.h"

#include <QPointer>
#include <QTimer>

class QDockWidget;

namespace handwheel {

class LathePanel;
class ManualLatheTool;
class WorkpieceDocument;
struct LatheChannel;

// The manual lathe in the window: its tool, its panel in a dock that is there as long as the tool runs, and what the
// device feels of it. Window thread.
class LatheView : public QObject {
  Q_OBJECT

 public:
  LatheView(const WindowContext& window, QObject* parent);
  ~LatheView() override;

  // The tool for a document; called when the user chooses it.
  std::unique_ptr<Tool> make(WorkpieceDocument& document, double spacing);
  // Whether the tool of the lathe runs.
  bool isOn() const { return tool() != nullptr; }

 private:
  ManualLatheTool* tool() const;
  void follow();
  void refresh();
  void feel();
  void makeDock();

  WindowContext m_window;
  ManualLatheTool* m_made = nullptr;  // the last one; it may be gone
  QPointer<QDockWidget> m_dock;
  QPointer<LathePanel> m_panel;
  QTimer m_refresh;
  bool m_wasLive = false;
  std::shared_ptr<const CuttingForceModel> m_law;
  std::shared_ptr<LatheChannel> m_felt;  // null: nothing of a lathe is felt
};

}  // namespace handwheel
