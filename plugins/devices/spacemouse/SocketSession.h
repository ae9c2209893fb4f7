// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"
#include "io/Session.h"
#include "spacemouse/SocketRecords.h"

#include <functional>
#include <memory>

namespace handwheel::spacemouse {

// Session with a SpaceMouse through the daemon spacenavd. The kernel passes only changes to the daemon, so no records
// arrive while the cap is held still. The session keeps the last displacement until the daemon reports another one or
// ends.
class SocketSession final : public Session {
 public:
  using Connect = std::function<Result<std::unique_ptr<ByteStream>>()>;
  explicit SocketSession(Connect connect) : m_connect(std::move(connect)) {}

  // Returns capabilities with 32 buttons, because the daemon does not report the number of buttons.
  DeviceCapabilities capabilities() const override { return capabilitiesWith(32); }
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override { m_stream.reset(); }

 private:
  Connect m_connect;
  std::unique_ptr<ByteStream> m_stream;  // null: the session is not open, or the daemon is gone
  SocketRecords m_records;
};

}  // namespace handwheel::spacemouse
