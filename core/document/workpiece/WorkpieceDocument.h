// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/workpiece/WorkpieceSnapshot.h"

#include <span>

namespace handwheel {

// Document of a workpiece, which is a bar for turning on a lathe.
class WorkpieceDocument : public Document {
  Q_OBJECT

 public:
  // The content of `opened` must be a WorkpieceSnapshot.
  explicit WorkpieceDocument(OpenedFile opened, QObject* parent = nullptr);

  const WorkpieceSnapshot& workpiece() const { return *m_workpiece; }

  // Adds crashes of the manual lathe or of a program. This is not an undo step, since crashes cannot be undone.
  void addCrashes(std::span<const LatheCollision> crashes);

  SnapshotPointer snapshot() const override { return m_workpiece; }
  // Returns the properties of workpieceProperties(), then those of every document.
  std::vector<Property> properties() const override;
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;

 private:
  Result<std::unique_ptr<Edit>> allowanceEdit(const PropertyValue& value) const;
  friend class WorkpieceEdit;
  friend class TargetEdit;
  friend class TurnedPartEdit;
  friend class LatheSetupEdit;
  friend class ProgramPostEdit;
  friend class ProgramToolsEdit;
  void set(WorkpieceSnapshot workpiece);

  std::shared_ptr<const WorkpieceSnapshot> m_workpiece;
};

}  // namespace handwheel
