// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "theme/DefectKind.h"
#include "tools/mesh/repair/ChangePreview.h"
#include "window/JobRunner.h"

#include <QAction>
#include <optional>

namespace handwheel {

class WindowServices;
struct MeshTab;

// A fix that can be tried. Its change is created only on demand, because it may list millions of triangles.
struct OfferedFix {
  // The members action, kind and row distinguish the fix from other fixes of the same mesh.
  const QAction* action;
  std::optional<DefectKind> kind;
  int row;  // row of the defect, or index of the loop; -1: the fix is for all defects
  std::function<std::optional<MeshChange>()> make;
};

// Shows the effect that the offered fix would have. The fix is tried on a worker thread as soon as it is offered. The
// trial is cancelled when the selection changes.
class FixPreview : public QObject {
  Q_OBJECT

 public:
  // isWanted: the check box that switches the previews.
  FixPreview(QThreadPool& pool, WindowServices& services, const QAction& isWanted, QObject* parent = nullptr);

  // Requests the preview of a fix. Does nothing if the preview is already shown or being computed. fix: none: the
  // preview is removed.
  void request(MeshTab* document, std::optional<OfferedFix> fix);

  bool isWorking() const { return m_isWorking; }
  // The shown preview. It is empty while there is none.
  const ChangePreview& shown() const { return m_shown; }
  // Returns true if the fix was tried and would do nothing.
  bool isPointless() const { return m_isReady && m_shown.isEmpty(); }
  QString text() const;  // "Removes 2 triangles, adds 3"; empty: there is no fix

 signals:
  void changed();

 private:
  void start();

  WindowServices& m_services;
  const QAction& m_isWanted;
  ServiceHandle m_need;  // held while a preview is wanted
  JobRunner m_runner;
  MeshTab* m_document = nullptr;
  std::uint64_t m_revision = 0;
  std::optional<OfferedFix> m_fix;
  std::uint64_t m_request = 0;
  bool m_isWorking = false;
  bool m_isReady = false;
  ChangePreview m_shown;
};

}  // namespace handwheel
