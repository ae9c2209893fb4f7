// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "document/workpiece/WorkpieceSnapshot.h"
#include "document/workpiece/target/TargetImport.h"
#include "viewport/overlay/LegendLayer.h"
#include "viewport/path/PathLayer.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"
#include "window/workpiece/TargetPanel.h"

#include <QAction>
#include <QPointer>

namespace handwheel {

class WorkpieceDocument;

// The commands and measurements for the target of a workpiece. The commands import, turn and remove the target, and
// show its outline and the deviation or roughness in colours.
class TargetActions : public QObject {
  Q_OBJECT

 public:
  TargetActions(const WindowContext& parts, QObject* parent);
  ~TargetActions() override;

  void setDocument(DocumentTab* document);
  void setVisible(bool isVisible);  // visibility of the document
  QList<QAction*> actions() { return {&m_import, &m_turn, &m_remove, &m_outline, &m_colours, &m_roughness}; }
  QWidget* panel() { return m_panel; }
  // Returns the workpiece in the colours of its deviation or its roughness. Returns nothing if colours are off.
  std::optional<DisplayModel> display(const WorkpieceSnapshot& workpiece) const;
  bool isSettled() const { return m_measuring.isIdle(); }

  // Reads a target as a job, asks for its position in the bar, and sets it as one undo step.
  void importFrom(DocumentTab* document, const QString& path);

 signals:
  void shownChanged();
  void message(const handwheel::Message& message);

 private:
  const WorkpieceDocument* workpiece() const;
  void askForFile();
  void askForPosition(DocumentTab* document, const ImportedTarget& imported, const QString& path);
  void turn();
  void propose(DocumentTab* document, std::shared_ptr<const WorkpieceTarget> target);
  void take(DocumentTab* document, const std::shared_ptr<const WorkpieceTarget>& target, const ImportedTarget& imported,
            const QString& path);
  void refresh();
  void measured(const PartMeasurement& measurement);
  void choose(const QAction& shown, QAction& other);
  void showOutline();
  void showLegend();

  WindowContext m_parts;
  QAction m_import, m_turn, m_remove, m_outline, m_colours, m_roughness;
  QPointer<TargetPanel> m_panel;
  DocumentTab* m_document = nullptr;
  JobRunner m_measuring;
  std::shared_ptr<PathLayer> m_layer;
  std::shared_ptr<LegendLayer> m_legend;
  std::shared_ptr<const WorkpieceTarget> m_outlined;  // the target in m_layer
  int m_facing = 0;                                   // outlineStep() of m_layer
  // target whose outline is shown while the user chooses its position; null: none
  std::shared_ptr<const WorkpieceTarget> m_proposed;
  bool m_isVisible = true;
  double m_range = 0.1;  // mm, range of the colours
};

}  // namespace handwheel
