// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/volume/VoxelizeSettings.h"
#include "window/kinds/KindUi.h"

#include <QPointer>

namespace handwheel {

class JobRunner;
class PropertyDialog;
class VolumeKind;

// The dialog that asks how to make a volume from the surface of another document. It shows the predicted cost while
// numbers are typed, and does not store its settings. A job measures the surface before the dialog opens. All functions
// must be called on the window thread.
class VoxelizeQuestion : public QObject {
  Q_OBJECT

 public:
  // kind: the document kind of the result; it must outlive this object.
  VoxelizeQuestion(QWidget* window, JobRunner& jobs, const VolumeKind& kind, QObject* parent);

  // Asks for the settings. start: function that receives the function that makes the volume; it is not called if the
  // user declines.
  void ask(const Document& from, VoxelizeSettings::Purpose purpose, std::function<void(MakeOfSurface)> start);

 signals:
  void message(const Message& message);

 private:
  void open(LengthUnit unit, std::function<void(MakeOfSurface)> start);
  std::vector<Property> shown() const;
  QString reasonText() const;
  MakeOfSurface wanted() const;

  QWidget* m_window;
  JobRunner& m_jobs;
  const VolumeKind& m_kind;
  QPointer<PropertyDialog> m_dialog;
  std::optional<VoxelizeSettings> m_settings;  // settings of the open dialog
};

}  // namespace handwheel
