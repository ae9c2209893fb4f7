// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"
#include "haptics/WorkspaceMapping.h"
#include "viewport/CameraState.h"

#include <optional>

namespace handwheel {

// How a device of this kind lies in the view before anybody has changed it. Its scale of 1 means that the workspace
// fills the view.
WorkspaceMapping standardMapping(const DeviceCapabilities& device);

// The user's part of a mapping, as it is kept in the settings for each driver: axes, scale, gain, dead zones, clutch.
// What is missing there or makes no sense is as in `standard`.
WorkspaceMapping keptMapping(const std::string& driver, const WorkspaceMapping& standard);
void keepMapping(const std::string& driver, const WorkspaceMapping& mapping);

// The user's mapping in a view of the model: the centre of the workspace lies before the model in the middle of the
// view, so that the tip does not begin inside it, and its radius spans half of the height. seen: the surface in the
// middle of the view, where that is known; it lies a little before it.
WorkspaceMapping mappingInView(const WorkspaceMapping& user, const DeviceCapabilities& device,
                               const CameraState& camera, const Box& model, const std::optional<Vec3>& seen = {});

// Whether a place, mm, can be seen, roughly: what the tip needs to stay where it is when the camera moves.
bool isInView(const CameraState& camera, const Vec3& place);

}  // namespace handwheel
