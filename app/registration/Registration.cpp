// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration/Registration.h"

#include "document/cell/CellKind.h"
#include "document/mesh/MeshKind.h"
#include "document/workpiece/WorkpieceKind.h"
#include "window/cell/CellUi.h"
#include "window/mesh/MeshUi.h"
#include "window/workpiece/WorkpieceUi.h"

namespace handwheel {

namespace {

template <class Ui>
std::unique_ptr<KindUi> make(const WindowContext& parts) {
  return std::make_unique<Ui>(parts);
}

}  // namespace

std::vector<KindEntry> registeredKinds() {
  std::vector<KindEntry> all;
  auto cell = std::make_unique<CellKind>();
  const auto cellWindow = [&kind = *cell](const WindowContext& parts) { return std::make_unique<CellUi>(parts, kind); };
  all.push_back({std::move(cell), cellWindow});
  all.push_back({std::make_unique<WorkpieceKind>(), make<WorkpieceUi>});
  auto mesh = std::make_unique<MeshKind>();
  const auto meshWindow = [&kind = *mesh](const WindowContext& parts) { return std::make_unique<MeshUi>(parts, kind); };
  all.push_back({std::move(mesh), meshWindow});
  return all;
}

}  // namespace handwheel
