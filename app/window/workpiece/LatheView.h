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

// The user interface of the manual lathe. It makes the tool of the lathe, shows the panel in a dock while the tool
// runs, applies the forces to the haptic device, and plays the sounds of the lathe and of the Turn tool. A space mouse
// moves the slides. It must be used on the window thread.
class LatheView : public QObject {
  Q_OBJECT

 public:
  LatheView(const WindowContext& window, QObject* parent);
  ~LatheView() override;

  // Makes the tool for a document. It is called when the user chooses the tool. The limits are those of its
  // exercise.
  std::unique_ptr<Tool> make(WorkpieceDocument& document);
  // Returns true if the tool of the lathe is running.
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
  void askForSize(bool isX, double typed, double measured);
  void showZero();
  void sayUndone(const ManualLatheTool& lathe);
  void leave();

  WindowContext m_window;
  QPointer<QDockWidget> m_dock;
  QPointer<LathePanel> m_panel;
  QTimer m_refresh;   // active while the lathe runs
  QTimer m_sounding;  // active while something turns
  TurningSound m_turning;
  std::shared_ptr<PathLayer> m_zeroLayer;
  std::pair<double, double> m_zero;  // mm: z and size of the drawn zero; size 0: no zero is drawn
  bool m_isFromBehind = false;       // the text of the zero is for a camera behind the part
  // State of the lathe of a document when its tool ended.
  struct Left {
    std::shared_ptr<std::optional<ManualLatheTool::Left>> machine;
    std::optional<LatheWheels::Rings> rings;
    double touch = 0.0;  // mm, the number for touching off
  };
  std::map<const QObject*, Left> m_left;          // states by document
  const WorkpieceDocument* m_document = nullptr;  // document of the last lathe
  const WorkpieceDocument* m_ringsOf = nullptr;   // document whose dial rings the panel shows
  int m_returns = 0;                     // number of times that undo or redo had moved the tool, at the last report
  std::pair<bool, bool> m_was;           // at the last refresh: the lathe was running (isLive()), and its pass had cut
  bool m_isPushed = false;               // true: a space mouse moves the slides
  int m_quiet = 0;                       // timeouts of m_sounding since the lathe last ran
  std::shared_ptr<LatheChannel> m_felt;  // null: the device feels no lathe
  std::shared_ptr<const LatheMaterial> m_feltMaterial;
};

}  // namespace handwheel
