// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/LatheMaterial.h"
#include "tools/workpiece/ManualLatheTool.h"
#include "window/kinds/KindUi.h"
#include "window/workpiece/LatheWheels.h"
#include "window/workpiece/TurningSound.h"

#include <QPointer>
#include <QTimer>
#include <map>

class QDockWidget;

namespace handwheel {

class LathePanel;
class PathLayer;

// The manual lathe in the window. It has its tool, its panel in a dock that exists while the tool runs, its forces on
// the device, and its sound and that of the Turn tool. A space mouse moves its slides. Window thread.
class LatheView : public QObject {
  Q_OBJECT

 public:
  LatheView(const WindowContext& window, QObject* parent);
  ~LatheView() override;

  // Makes the tool for a document; called when the user chooses it. forceLimit: N, of its exercise; 0: none.
  std::unique_ptr<Tool> make(WorkpieceDocument& document, double forceLimit);
  // Returns true if the tool of the lathe runs.
  bool isOn() const { return tool() != nullptr; }

 signals:
  void message(const handwheel::Message& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  ManualLatheTool* tool() const;
  void follow();
  void refresh();
  void feel();
  void makeDock();
  void giveRoom();
  void showDock(bool isShown);
  void face(const ManualLatheTool& lathe);
  void sound();
  void push(const Vec3& motion);
  void mount(const QString& tool);
  void touchOff(bool isX, double value, bool isConfirmed);
  void showZero();
  void sayUndone(const ManualLatheTool& lathe);
  void leave();

  WindowContext m_window;
  QPointer<QDockWidget> m_dock;
  QPointer<LathePanel> m_panel;
  QTimer m_refresh;   // while the lathe runs
  QTimer m_sounding;  // while something turns
  TurningSound m_turning;
  std::shared_ptr<PathLayer> m_zeroLayer;
  std::pair<double, double> m_zero;  // mm: z of the drawn zero, and its size; 0: none is drawn
  // State of the lathe of a document when its tool ended.
  struct Left {
    std::shared_ptr<std::optional<ManualLatheTool::Left>> machine;
    std::optional<LatheWheels::Rings> rings;
    double touch = 0.0;  // mm, the number for touching off
  };
  std::map<const QObject*, Left> m_left;          // by document
  const WorkpieceDocument* m_document = nullptr;  // document of the last lathe
  const WorkpieceDocument* m_ringsOf = nullptr;   // document of the rings in the panel
  int m_returns = 0;                              // return count of the tool when it was last reported
  std::pair<bool, bool> m_was;                    // last state: live, and with a pass under motion
  bool m_isPushed = false;                        // a space mouse moves the slides
  int m_quiet = 0;                                // timeouts of m_sounding since the lathe was last live
  std::shared_ptr<LatheChannel> m_felt;           // null: the device feels no lathe
  std::shared_ptr<const LatheMaterial> m_feltMaterial;
};

}  // namespace handwheel
