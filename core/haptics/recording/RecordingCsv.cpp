// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordingCsv.h"

#include "base/NumberText.h"

#include <ostream>
#include <span>

namespace handwheel {

namespace {

constexpr std::size_t kTicksAtOnce = 1000;

void addNumbers(std::string& line, const Vec3& v) {
  for (const double x : v) line += ',' + shortestText(x);
}

// Appends a text in quotes, and with quotes doubled (RFC 4180): any text is one field.
void addText(std::string& line, const std::string& text) {
  line += '"';
  for (const char c : text) line += c == '"' ? std::string("\"\"") : std::string(1, c);
  line += '"';
}

void addTick(std::string& line, const RecordedTick& tick) {
  line += shortestText(tick.tip.time);
  addNumbers(line, tick.tip.position);
  addNumbers(line, tick.felt.proxy);
  addNumbers(line, tick.felt.force);
  line += tick.felt.isContact ? ",1," : ",0,";
  line += roundedText(static_cast<double>(tick.microseconds)) + ',' + std::to_string(tick.tip.buttons);
  addNumbers(line, tick.sent.force);
  line += ',' + std::to_string(tick.actions) + ',' + std::to_string(tick.tick);
  const Eigen::Quaterniond& turn = tick.tip.orientation;
  line += ',' + shortestText(turn.w());
  addNumbers(line, turn.vec());
  addNumbers(line, tick.felt.torque);
  addNumbers(line, tick.sent.torque);
  addNumbers(line, tick.tip.velocity);
  for (const double x : {tick.tip.period, tick.tip.stiffnessLimit, tick.tip.dampingLimit})
    line += ',' + shortestText(x);
  line += tick.tip.isRestart ? ",1" : ",0";
  line += tick.hasSource ? ",1," : ",0,";
}

// Appends the events of a tick, with those that describe a scene in a column of their own.
void addEvents(std::string& line, std::span<const RecordedEvent> events) {
  std::string happened, scenes;
  for (const RecordedEvent& event : events) {
    const bool isScene = event.text.starts_with(kSceneEvent);
    std::string& list = isScene ? scenes : happened;
    const char* const separator = isScene ? "\n" : "; ";
    list += (list.empty() ? "" : separator) + event.text.substr(isScene ? kSceneEvent.size() : 0);
  }
  if (!happened.empty()) addText(line, happened);
  line += ',';
  if (!scenes.empty()) addText(line, scenes);
}

}  // namespace

Status writeCsv(const Recording& recording, std::ostream& out, Progress progress) {
  out << "t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us,buttons,sent_x,sent_y,"
         "sent_z,safety,tick,hip_qw,hip_qx,hip_qy,hip_qz,torque_x,torque_y,torque_z,sent_torque_x,sent_torque_y,"
         "sent_torque_z,hip_vx,hip_vy,hip_vz,period_s,stiffness_limit,damping_limit,restart,in_scene,event,scene\n";
  auto event = recording.events().begin();
  std::string lines;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    addTick(lines, recording[i]);
    const auto first = event;
    while (event != recording.events().end() && event->tick <= recording[i].tick) ++event;
    addEvents(lines, {first, event});
    lines += '\n';
    if (i % kTicksAtOnce != kTicksAtOnce - 1 && i + 1 < recording.size()) continue;
    out << lines;
    lines.clear();
    progress.set(static_cast<double>(i + 1) / static_cast<double>(recording.size()));
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  }
  if (!out.flush()) return Error{ErrorCode::WriteFailed, {""}, {}, {}};
  return Done{};
}

}  // namespace handwheel
