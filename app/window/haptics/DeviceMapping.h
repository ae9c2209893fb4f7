// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/mapping/WorkspaceMapping.h"
#include "mesh/search/PickRay.h"
#include "viewport/camera/CameraState.h"

#include <array>
#include <optional>

namespace handwheel {

// Returns the default mapping of a device into the view. A scale of 1 means that the workspace fills the view.
WorkspaceMapping standardMapping(const DeviceCapabilities& device);

// Loads the user's settings of a mapping, stored for each driver: axes, scale, gain, dead zones, clutch. Missing or
// invalid values are taken from `standard`.
WorkspaceMapping loadMapping(const std::string& driver, const WorkspaceMapping& standard);
// Stores the user's settings of a mapping.
void storeMapping(const std::string& driver, const WorkspaceMapping& mapping);

// Places the user's mapping in a view of the model. The centre of the workspace lies in front of the model in the
// middle of the view, so that the tip does not start inside the model. The radius of the workspace is half the height
// of the view. seen: the surface point in the middle of the view, if it is known; the centre lies a little in front of
// this point.
WorkspaceMapping mappingInView(const WorkspaceMapping& user, const DeviceCapabilities& device,
                               const CameraState& camera, const Box& model, const std::optional<Vec3>& seen = {});

// The direction of a device axis relative to an axis in the scene, such as that of a lathe. Along: parallel to the
// axis. Radius: away from the axis. Across: around the axis. Oblique: none of these.
enum class AboutAxis { Oblique, Along, Radius, Across };
// Returns the direction of each device axis for a tip at this position.
std::array<AboutAxis, 3> axesAbout(const Ray& axis, const WorkspaceMapping& inScene, const Vec3& tip);

// Returns true if a point (mm) is roughly within the view. The tip stays unchanged in that case when the camera moves.
bool isInView(const CameraState& camera, const Vec3& point);

}  // namespace handwheel
