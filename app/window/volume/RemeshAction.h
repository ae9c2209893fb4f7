// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "tools/volume/VoxelizeOperations.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"

#include <QPointer>

namespace handwheel {

class PropertyDialog;
struct VolumeSnapshot;

// The command “Make mesh…” of volumes. It asks for the largest error or the number of triangles, predicts number and
// time, and opens the mesh as a new document. All functions must be called on the window thread.
class RemeshAction : public QObject {
  Q_OBJECT

 public:
  RemeshAction(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_action; }
  void setDocument(DocumentTab* document);  // null: no volume is current
  bool isSettled() const { return m_predicting.isIdle(); }

 signals:
  void message(const handwheel::Message& message);

 private:
  enum class Goal { All, Distance, Count };

  void ask();
  std::vector<Property> shown() const;
  Status change(const std::string& id, const PropertyValue& value);
  OperationValues wanted() const;
  void predict();
  void make(const std::string& title, bool isPrivate, LengthUnit unit, const Document* owner);

  WindowContext m_parts;
  QAction m_action;
  DocumentTab* m_document = nullptr;
  QPointer<PropertyDialog> m_dialog;
  std::shared_ptr<const VolumeSnapshot> m_volume;  // volume of the open dialog
  Goal m_goal = Goal::Distance;
  OperationValues m_values;
  std::optional<RemeshPrediction> m_predicted;  // none: the triangles are still being counted
  JobRunner m_predicting;
};

}  // namespace handwheel
