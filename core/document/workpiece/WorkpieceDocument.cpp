// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceDocument.h"

#include "document/workpiece/WorkpieceEdit.h"
#include "document/workpiece/WorkpieceErrors.h"
#include "document/workpiece/target/TargetEdit.h"
#include "document/workpiece/target/TargetPosition.h"

namespace handwheel {

WorkpieceDocument::WorkpieceDocument(OpenedFile opened, QObject* parent)
    : Document(*opened.kind, std::move(opened.file), parent),
      m_workpiece(std::static_pointer_cast<const WorkpieceSnapshot>(opened.content)) {}

std::vector<Property> WorkpieceDocument::properties() const {
  std::vector<Property> all = workpieceProperties(*m_workpiece);
  for (Property& own : all) {
    const auto field = fieldNamed(own.id);
    const bool isGiven = own.id == kAllowanceId || (field && isOfAnExercise(*field));
    if (file().assigned && isGiven) own.editable = false;
    if (field == WorkpieceField::Material) own.value = materialInWords(m_workpiece->material);
  }
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

Result<std::unique_ptr<Edit>> WorkpieceDocument::propertyEdit(const std::string& id, const PropertyValue& value) const {
  if (id == kAllowanceId && m_workpiece->target) return allowanceEdit(value);
  const auto field = fieldNamed(id);
  if (!field) return Document::propertyEdit(id, value);
  if (file().assigned && isOfAnExercise(*field)) return Error{WorkpieceError::BarOfExercise, {}, {}, {}};
  if (m_workpiece->part && isOfTheBar(*field)) return Error{WorkpieceError::SizeFixed, {}, {}, {}};
  const Status checked = checkValue(*field, value);
  if (!checked) return checked.error();
  const PropertyValue stored =
      *field == WorkpieceField::Material ? PropertyValue(materialOfWords(std::get<std::string>(value))) : value;
  if (propertyOf(*m_workpiece, *field).value == stored) return std::unique_ptr<Edit>();
  return std::unique_ptr<Edit>(std::make_unique<WorkpieceEdit>(*field, stored));
}

Result<std::unique_ptr<Edit>> WorkpieceDocument::allowanceEdit(const PropertyValue& value) const {
  if (file().assigned) return Error{WorkpieceError::BarOfExercise, {}, {}, {}};
  const WorkpieceTarget& target = *m_workpiece->target;
  Result<TargetProfile> placed = withPosition(target.profile, m_workpiece->stock, value);
  if (!placed) return placed.error();
  if (*placed == target.profile) return std::unique_ptr<Edit>();
  return std::unique_ptr<Edit>(std::make_unique<TargetEdit>(
      std::make_shared<const WorkpieceTarget>(WorkpieceTarget{std::move(*placed), target.source})));
}

void WorkpieceDocument::addCrashes(std::span<const LatheCollision> crashes) {
  WorkpieceSnapshot workpiece = *m_workpiece;
  if (!handwheel::addCrashes(workpiece, crashes)) return;
  m_workpiece = std::make_shared<const WorkpieceSnapshot>(std::move(workpiece));
  wasRecorded();
}

void WorkpieceDocument::set(WorkpieceSnapshot workpiece) {
  m_workpiece = std::make_shared<const WorkpieceSnapshot>(std::move(workpiece));
  wasChanged();
}

}  // namespace handwheel
