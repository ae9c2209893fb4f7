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

// The dialog that asks how a volume is made of the surface of another document. It shows what that is going to take,
// while numbers are typed, and remembers nothing. The surface is measured by a job before. Window thread.
class VoxelizeQuestion : public QObject {
  Q_OBJECT

 public:
  // kind: of what is made; it outlives this.
  VoxelizeQuestion(QWidget* window, JobRunner& jobs, const VolumeKind& kind, QObject* parent);

  // start: called with what makes the volume, unless the user declines.
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
  std::optional<VoxelizeSettings> m_settings;  // while the dialog is open
};

}  // namespace handwheel
