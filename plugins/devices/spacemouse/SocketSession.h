// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"
#include "io/Session.h"
#include "spacemouse/SocketRecords.h"

#include <functional>
#include <memory>

namespace handwheel::spacemouse {

// Session with a SpaceMouse by the daemon spacenavd. The kernel passes only changes to the daemon, so a cap that is
// held still sends nothing: it keeps its displacement until the daemon reports otherwise or ends.
class SocketSession final : public Session {
 public:
  using Connect = std::function<Result<std::unique_ptr<ByteStream>>()>;
  explicit SocketSession(Connect connect) : m_connect(std::move(connect)) {}

  // Returns the number of buttons is not known.
  DeviceCapabilities capabilities() const override { return capabilitiesWith(32); }
  Status open(Progress progress) override;
  DeviceState exchange(const DeviceForce& force) noexcept override;
  void close() noexcept override { m_stream.reset(); }

 private:
  Connect m_connect;
  std::unique_ptr<ByteStream> m_stream;  // null: not open, or gone
  SocketRecords m_records;
};

}  // namespace handwheel::spacemouse
