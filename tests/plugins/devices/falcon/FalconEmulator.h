// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ContractSubject.h"
#include "FakeClock.h"
#include "falcon/Session.h"
#include "io/ThreadedDevice.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <numeric>

namespace handwheel {

// An emulator of a Falcon connected through its FTDI chip. It has bootloader, firmware, homing, motors, and the known
// faults. It follows the description of the protocol, not the code that it tests. It may be used on any thread that
// holds its mutex.
class FalconEmulator {
 public:
  using Bytes = std::vector<std::uint8_t>;

  std::mutex mutex;
  Bytes image = [] {  // the firmware that it accepts
    Bytes bytes(7914);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
    return bytes;
  }();

  // Simulated faults.
  int spoiltLoads = 0;       // number of following loads with a wrong echo
  int deafGreetings = 0;     // number of following greetings without an answer
  bool leadingZero = false;  // sends a zero before the answer to a greeting
  int shortEvery = 0;        // n: each n-th answer lacks its last two bytes
  bool stalled = false;
  bool lateOnce = false;        // the next answer arrives after the driver has stopped waiting
  std::size_t unpluggedAt = 0;  // byte of a load at which the device is unplugged; 0: never
  bool gone = false;

  // State of the device.
  bool running = false;
  int packetsToHoming = 0;  // packets with the homing bit that are needed until it knows its position
  std::array<int, 3> encoders{};
  std::uint8_t buttons = 0;

  // Record of events.
  int loads = 0;
  int packets = 0;
  int largestBeforeHomed = 0;  // largest torque before homing, counts
  std::optional<std::array<int, 3>> torques;
  std::uint8_t lights = 0;
  std::deque<std::uint8_t> toHost;
  Bytes late;  // an answer that arrives with the fifth following transfer
  int transfers = 0;

  void transfer() {
    transfers = late.empty() ? 0 : transfers + 1;
    if (transfers < 5) return;
    send(late);
    late.clear();
  }

  bool isHomed() const { return packetsToHoming <= 0; }

  void control(std::uint8_t request, std::uint16_t value) {
    if (request == 3) setBaud(value);
    if (request == 0 && value == 1) toHost.clear();
  }

  void receive(std::span<const std::uint8_t> bytes) {
    if (m_baud == 0x4138) greet(bytes);
    if (m_baud == 0x0015) load(bytes);
    if (m_baud == 0x0002 && running && !stalled) packet(bytes);
  }

 private:
  void send(std::span<const std::uint8_t> bytes) { toHost.insert(toHost.end(), bytes.begin(), bytes.end()); }

  void setBaud(std::uint16_t divisor) {
    if (divisor == 0x4138) m_greeted = false;
    if (divisor == 0x0015) {
      ++loads;
      m_begun = false;
      m_loaded.clear();
    }
    m_baud = divisor;
  }

  void greet(std::span<const std::uint8_t> bytes) {
    static const Bytes kGreeting = {0x0a, 0x43, 0x0d}, kAnswer = {0x0a, 0x44, 0x2c, 0x0d};
    if (running || !std::equal(bytes.begin(), bytes.end(), kGreeting.begin(), kGreeting.end())) return;
    if (deafGreetings-- > 0) return;
    if (leadingZero) toHost.push_back(0);
    send(kAnswer);
    m_greeted = true;
  }

  void load(std::span<const std::uint8_t> bytes) {
    if (!m_greeted || bytes.size() > 62) return;
    Bytes echo(bytes.begin(), bytes.end());
    if (!m_begun) {
      m_begun = echo == Bytes{0x41};
    } else {
      m_loaded.insert(m_loaded.end(), echo.begin(), echo.end());
      if (m_loaded.size() > 3000 && spoiltLoads > 0) {
        --spoiltLoads;
        m_greeted = false;
        echo.back() ^= 1;
      }
      if (m_loaded == image) running = true;
      gone |= unpluggedAt > 0 && m_loaded.size() >= unpluggedAt;
    }
    send(echo);
  }

  static int number(const Bytes& packet, std::size_t at) {
    int value = 0;
    for (int i = 3; i >= 0; --i) value = value << 4 | (packet[at + i] - 'A');
    return value >= 0x8000 ? value - 0x10000 : value;
  }

  void packet(std::span<const std::uint8_t> bytes) {
    const Bytes in(bytes.begin(), bytes.end());
    if (in.size() != 16 || in[0] != '<' || in[15] != '>') return;
    ++packets;
    torques = {number(in, 1), number(in, 5), number(in, 9)};
    lights = static_cast<std::uint8_t>(in[13] - 'A');
    if (!isHomed()) {
      for (const int torque : *torques) largestBeforeHomed = std::max(largestBeforeHomed, std::abs(torque));
      if (lights & 1) --packetsToHoming;
    }
    answer();
  }

  void answer() {
    Bytes out = {'<'};
    for (const int encoder : encoders) {
      for (int nibble = 0; nibble < 4; ++nibble) {
        out.push_back(static_cast<std::uint8_t>('A' + (((isHomed() ? encoder : 31000) >> 4 * nibble) & 15)));
      }
    }
    out.push_back(static_cast<std::uint8_t>('A' + (buttons & 15) + (isHomed() ? 0x70 : 0)));
    out.push_back('A');
    out.push_back('>');
    if (shortEvery > 0 && packets % shortEvery == 0) out.resize(14);
    if (lateOnce) {
      late = out;
      lateOnce = false;
    } else {
      send(out);
    }
  }

  std::uint16_t m_baud = 0;
  bool m_greeted = false;
  bool m_begun = false;
  Bytes m_loaded;
};

// A USB transport that is connected to the emulator. Received transfers consist of packets of 64 bytes, each of which
// begins with two status bytes of the chip.
class FakeUsb final : public UsbTransport {
 public:
  FakeUsb(std::shared_ptr<FalconEmulator> falcon, std::shared_ptr<FakeClock> clock)
      : m_falcon(std::move(falcon)), m_clock(std::move(clock)) {}

  bool control(std::uint8_t request, std::uint16_t value) noexcept override {
    const std::lock_guard lock(m_falcon->mutex);
    if (!m_falcon->gone) m_falcon->control(request, value);
    return !m_falcon->gone;
  }

  bool write(std::span<const std::uint8_t> bytes) noexcept override {
    const std::lock_guard lock(m_falcon->mutex);
    if (!m_falcon->gone) m_falcon->receive(bytes);
    return !m_falcon->gone;
  }

  std::ptrdiff_t read(std::span<std::uint8_t> into, double) noexcept override {
    m_clock->pace();
    const std::lock_guard lock(m_falcon->mutex);
    m_clock->sleep(0.001);  // the chip sends its status each ms, with or without data
    if (m_falcon->gone) return kGone;
    m_falcon->transfer();
    std::size_t filled = 0;
    do {
      into[filled++] = 0x01;
      into[filled++] = 0x60;
      for (int i = 0; i < 62 && !m_falcon->toHost.empty(); ++i) {
        into[filled++] = m_falcon->toHost.front();
        m_falcon->toHost.pop_front();
      }
    } while (!m_falcon->toHost.empty() && filled % 64 == 0 && filled + 64 <= into.size());
    return static_cast<std::ptrdiff_t>(filled);
  }

  bool isGone() const noexcept override {
    const std::lock_guard lock(m_falcon->mutex);
    return m_falcon->gone;
  }

 private:
  std::shared_ptr<FalconEmulator> m_falcon;
  std::shared_ptr<FakeClock> m_clock;
};

inline std::unique_ptr<falcon::Session> falconSession(const std::shared_ptr<FalconEmulator>& device,
                                                      const std::shared_ptr<FakeClock>& clock) {
  const auto connect = [=]() -> Result<std::unique_ptr<UsbTransport>> {
    return std::unique_ptr<UsbTransport>(std::make_unique<FakeUsb>(device, clock));
  };
  const auto firmware = [=]() -> Result<falcon::Firmware> { return device->image; };
  return std::make_unique<falcon::Session>(connect, firmware, clock);
}

inline ContractSubject falconSubject() {
  const auto device = std::make_shared<FalconEmulator>();
  const auto clock = std::make_shared<FakeClock>(FakeClock::Pace::Real);
  device->running = true;
  device->packetsToHoming = 20;
  return {[=] { return std::make_unique<ThreadedDevice>(falconSession(device, clock)); },
          [=] {
            const std::lock_guard lock(device->mutex);
            device->gone = true;
          },
          [=] {
            const std::lock_guard lock(device->mutex);
            device->encoders = {32767, -32768, 32767};
            for (const char c : std::string("<<AA>~\xff<ZZZZZZZZZZZZZZ>")) {
              device->toHost.push_back(static_cast<std::uint8_t>(c));
            }
          },
          [=]() -> std::optional<Vec3> {
            const std::lock_guard lock(device->mutex);
            if (!device->torques) return {};
            const auto& counts = *device->torques;
            const Vec3 torque = Vec3(counts[0], counts[1], counts[2]) / falcon::kCountsPerTorque;
            return Vec3(falcon::jacobian(*falcon::forward(falcon::anglesOf({}), falcon::kHome)).transpose() * torque);
          }};
}

}  // namespace handwheel
