// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"
#include "io/Clock.h"
#include "io/DeviceHostMessages.h"
#include "io/Session.h"

#include <atomic>

namespace handwheel::guard {

// Holds a device for a program in another process (OutOfProcessSession). The motors do not depend on that program: if
// the program is gone, sends invalid messages, or sends nothing for kSilence, the host sends zero force to the device.
// After a silence the device is reported as starting, and forces are treated as zero, for kRest at least and until the
// program requests zero force. This is long enough for the program's servo loop to notice the interruption and to ramp
// up the force again.
class SessionHost {
 public:
  static constexpr double kSilence = 0.04;  // s
  static constexpr double kRest = 0.05;     // s

  // The referenced objects must outlive the host. Setting `stop` ends serve() as if the program had gone.
  SessionHost(Session& session, ByteStream& stream, Clock& clock, const std::atomic<bool>& stop)
      : m_session(session), m_stream(stream), m_clock(clock), m_stop(stop) {}

  // Serves the program from its request to open the device until it closes the device or is gone. The device is closed
  // in any case.
  void serve();

 private:
  bool waitForOpen();
  bool open();
  void run();
  bool listen(double timeout);
  bool answer(const Force& asked);
  bool send(const Message& message);

  Session& m_session;
  ByteStream& m_stream;
  Clock& m_clock;
  const std::atomic<bool>& m_stop;
  Reader m_reader;
  Buffer m_out{};
  std::optional<Open> m_open;    // the request to open the device
  std::optional<Force> m_force;  // the newest force that was not answered yet
  bool m_isLeft = false;         // the program is gone, or has closed the device
  bool m_hasBeenSilent = false;
  std::optional<double> m_restEnd;  // s; set when messages come again after a silence
};

}  // namespace handwheel::guard
