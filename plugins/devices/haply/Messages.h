// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

#include <optional>
#include <string>
#include <string_view>

namespace handwheel::haply {

// What one state frame of the service says of the first Inverse3 and the first VerseGrip. In the frame of Device.h, mm.
struct Frame {
  std::string deviceId;  // never empty
  std::optional<Vec3> position;
  std::optional<Vec3> velocity;
  std::optional<Eigen::Quaterniond> orientation;  // of the VerseGrip
  std::uint32_t buttons = 0;
  bool isCalibrated = true;
};

// Field names of versions 3.0 to 3.5; what is not known is passed over. Nothing when the text is no JSON or names no
// Inverse3.
std::optional<Frame> readFrame(std::string_view text);

// The first message of a client: it names itself and asks for the inventory.
std::string greeting();
// Sends the arm's origin to the middle of its workspace, once.
std::string centring(const std::string& deviceId);
// A force in the frame of Device.h, N, which holds until the next message.
std::string forceCommand(const std::string& deviceId, const Vec3& force);

}  // namespace handwheel::haply
