// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "builtin/BuiltInKinds.h"

#include "cli/cell/CellCommands.h"
#include "cli/cell/CellFile.h"
#include "cli/exercise/ExerciseCommands.h"
#include "cli/mesh/MeshCommands.h"
#include "cli/volume/VolumeCommands.h"
#include "cli/workpiece/WorkpieceCommands.h"
#include "document/cell/RobotCellKind.h"
#include "document/exercise/ExerciseKind.h"
#include "document/mesh/MeshKind.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/exercise/DrillingSubject.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/exercise/TurningSubject.h"
#include "window/cell/RobotCellUi.h"
#include "window/exercise/ExerciseUi.h"
#include "window/mesh/MeshUi.h"
#include "window/volume/VolumeUi.h"
#include "window/workpiece/WorkpieceUi.h"

namespace handwheel {

namespace {

// Creates the window part of a kind, with or without the kind as an argument.
template <class Ui, class Kind>
KindEntry entryWithKind() {
  auto kind = std::make_unique<Kind>();
  const auto window = [&known = *kind](const WindowContext& parts) { return std::make_unique<Ui>(parts, known); };
  return {std::move(kind), window};
}

template <class Ui, class Kind>
KindEntry entryOf() {
  return {std::make_unique<Kind>(), [](const WindowContext& parts) { return std::make_unique<Ui>(parts); }};
}

// The registration of exercises, with the subjects that exercises can have.
KindEntry exerciseEntry() {
  std::vector<std::unique_ptr<ExerciseSubject>> subjects;
  subjects.push_back(std::make_unique<TurningSubject>());
  subjects.push_back(std::make_unique<DrillingSubject>());
  auto kind = std::make_unique<ExerciseKind>(std::move(subjects));
  const auto window = [](const WindowContext& parts) { return std::make_unique<ExerciseUi>(parts); };
  return {std::move(kind), window};
}

std::vector<KindEntry> entriesOf(std::vector<KindRegistration>& registrations) {
  std::vector<KindEntry> entries;
  for (KindRegistration& registration : registrations) entries.push_back(std::move(registration.entry));
  return entries;
}

}  // namespace

std::vector<KindRegistration> builtInKinds() {
  std::vector<KindRegistration> all;
  all.push_back({entryWithKind<RobotCellUi, RobotCellKind>(), cellCommands(), shippedRobot});
  all.push_back({exerciseEntry(), exerciseCommands()});
  all.push_back({entryWithKind<VolumeUi, VolumeKind>(), volumeCommands()});
  all.push_back({entryOf<WorkpieceUi, WorkpieceKind>(), workpieceCommands()});
  all.push_back({entryWithKind<MeshUi, MeshKind>(), meshCommands()});
  return all;
}

BuiltInKinds::BuiltInKinds(std::vector<KindRegistration> registrations) : set(entriesOf(registrations)) {
  for (KindRegistration& registration : registrations) {
    commands.insert(commands.end(), registration.commands.begin(), registration.commands.end());
    if (registration.shipped) shipped.push_back(registration.shipped);
  }
}

}  // namespace handwheel
