// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ContractSubject.h"
#include "FakeStream.h"
#include "haply/Session.h"
#include "haptics/device/DeviceErrors.h"
#include "io/ThreadedDevice.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <nlohmann/json.hpp>
#include <string>

namespace handwheel {

// An emulator of the Inverse service according to its documentation. It sends one frame for each message, and forces
// hold for one message. It checks the messages that it receives, and closes the connection if they do not follow the
// WebSocket protocol.
struct HaplyEmulator final : Peer {
  nlohmann::json position = {{"x", 0.01}, {"y", -0.02}, {"z", 0.03}};
  bool calibrated = true;
  bool stalled = false;
  bool grip = true;
  bool pings = false;
  std::size_t fragment = 0;  // length of the longest frame of its messages; 0: no limit
  std::string replyInstead;  // reply that replaces the normal one; empty: the normal reply
  std::string consent = "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n";
  bool answersTheKey = true;

  std::string key;  // key of the handshake
  int messages = 0;
  int pongs = 0;
  bool saidGoodbye = false;
  std::string preset;
  std::optional<Vec3> force;  // force of the last message, in the service's own frame

  void receive(std::span<const std::uint8_t> bytes) override {
    m_in.append(bytes.begin(), bytes.end());
    if (!m_upgraded) upgrade();
    while (m_upgraded && !gone && takeFrame()) {
    }
  }

  void frame(int opcode, const std::string& payload, bool isLast = true) {
    std::string head(1, static_cast<char>((isLast ? 0x80 : 0) | opcode));
    if (payload.size() < 126) {
      head += static_cast<char>(payload.size());
    } else {
      head += static_cast<char>(126);
      head += static_cast<char>(payload.size() >> 8 & 0xff);
      head += static_cast<char>(payload.size() & 0xff);
    }
    put(head + payload);
  }

 private:
  void put(const std::string& bytes) { toHost.insert(toHost.end(), bytes.begin(), bytes.end()); }

  void upgrade() {
    const std::size_t end = m_in.find("\r\n\r\n");
    if (end == std::string::npos) return;
    const bool asks = m_in.starts_with("GET / HTTP/1.1\r\n") && m_in.find("Upgrade: websocket") < end &&
                      m_in.find("Sec-WebSocket-Version: 13") < end;
    const std::string field = "Sec-WebSocket-Key: ";
    const std::size_t at = std::min(m_in.find(field), end);
    key = m_in.substr(at, m_in.find("\r\n", at) - at);
    key.erase(0, field.size());
    m_in.erase(0, end + 4);
    m_upgraded = asks && QByteArray::fromBase64(QByteArray::fromStdString(key)).size() == 16;
    if (!m_upgraded) return put("HTTP/1.1 400 Bad Request\r\n\r\n");
    // RFC 6455, section 4.2.2
    const std::string heard = (answersTheKey ? key : std::string()) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
    const QByteArray hash = QCryptographicHash::hash(QByteArray::fromStdString(heard), QCryptographicHash::Sha1);
    put(consent + "Sec-WebSocket-Accept: " + hash.toBase64().toStdString() + "\r\n\r\n");
  }

  bool takeFrame() {
    const auto at = [this](std::size_t i) { return static_cast<std::uint8_t>(m_in[i]); };
    if (m_in.size() < 6) return false;
    std::size_t length = at(1) & 0x7f, start = 2;
    if (length == 126) {
      if (m_in.size() < 8) return false;
      length = at(2) << 8 | at(3);
      start = 4;
    }
    if (!(at(1) & 0x80) || !(at(0) & 0x80)) gone = true;  // must be masked and not fragmented
    if (m_in.size() < start + 4 + length) return false;
    std::string payload;
    for (std::size_t i = 0; i < length; ++i) payload += static_cast<char>(at(start + 4 + i) ^ at(start + i % 4));
    const int opcode = at(0) & 15;
    m_in.erase(0, start + 4 + length);
    if (opcode == 1) message(payload);
    if (opcode == 8) saidGoodbye = true;
    if (opcode == 10) ++pongs;
    return true;
  }

  void message(const std::string& text) {
    ++messages;
    const nlohmann::json json = nlohmann::json::parse(text);
    if (json.contains("inverse3")) {
      const nlohmann::json& arm = json["inverse3"][0];
      if (arm["device_id"] != "049D") gone = true;
      if (arm.contains("configure")) preset = arm["configure"]["preset"];
      force = Vec3::Zero();
      if (arm.contains("commands")) {
        const nlohmann::json& v = arm["commands"]["set_cursor_force"]["vector"];
        force = Vec3(v["x"], v["y"], v["z"]);
      }
    }
    if (pings) frame(9, "are you there");
    if (!stalled) reply();
  }

  void reply() {
    nlohmann::json arm = {{"device_id", "049D"},
                          {"state", {{"cursor_position", position}, {"control_mode", "idle"}}},
                          {"status", {{"calibrated", calibrated}}}};
    nlohmann::json json = {{"session_id", 7}, {"inverse3", {arm}}};
    if (grip) {
      json["verse_grip"] = nlohmann::json::array(
          {{{"device_id", "G"},
            {"state", {{"button", true}, {"orientation", {{"w", 0}, {"x", 0}, {"y", 0}, {"z", 1}}}}}}});
    }
    const std::string text = replyInstead.empty() ? json.dump() : replyInstead;
    const std::size_t piece = fragment > 0 ? fragment : text.size();
    for (std::size_t at = 0; at < text.size(); at += piece) {
      frame(at == 0 ? 1 : 0, text.substr(at, piece), at + piece >= text.size());
    }
  }

  std::string m_in;
  bool m_upgraded = false;
};

inline ContractSubject haplySubject() {
  // The state that the functions of the subject share. Each connection gets a new emulator.
  struct World {
    std::mutex mutex;
    std::shared_ptr<HaplyEmulator> peer = std::make_shared<HaplyEmulator>();
    bool gone = false;
  };
  const auto world = std::make_shared<World>();
  const auto clock = std::make_shared<FakeClock>(FakeClock::Pace::Real);
  const auto connect = [=]() -> Result<std::unique_ptr<ByteStream>> {
    const std::lock_guard lock(world->mutex);
    if (world->gone) return Error{DeviceError::Unreachable, {"stopped"}, {}, {}};
    world->peer = std::make_shared<HaplyEmulator>();
    return std::unique_ptr<ByteStream>(std::make_unique<FakeStream>(world->peer, clock));
  };
  const auto current = [=] {
    const std::lock_guard lock(world->mutex);
    return world->peer;
  };
  return {[=] { return std::make_unique<ThreadedDevice>(std::make_unique<haply::Session>(connect, clock)); },
          [=] {
            const auto peer = current();
            const std::lock_guard lock(world->mutex);
            const std::lock_guard peerLock(peer->mutex);
            world->gone = peer->gone = true;
          },
          [=] {
            const auto peer = current();
            const std::lock_guard lock(peer->mutex);
            peer->replyInstead =
                R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":1e308,"y":"a","z":null}}}]})";
          },
          [=]() -> std::optional<Vec3> {
            const auto peer = current();
            const std::lock_guard lock(peer->mutex);
            if (!peer->force) return {};
            return Vec3(peer->force->x(), peer->force->z(), -peer->force->y());
          }};
}

}  // namespace handwheel
