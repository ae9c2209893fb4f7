// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordingCsv.h"

#include "base/NumberText.h"

#include <ostream>

namespace handwheel {

namespace {

constexpr std::size_t kTicksAtOnce = 1000;

void addNumbers(std::string& line, const Vec3& v) {
  for (const double x : v) line += ',' + shortestText(x);
}

// In quotes, and quotes doubled (RFC 4180): any text is one field.
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
  line += ',';
}

}  // namespace

Status writeCsv(const Recording& recording, std::ostream& out, Progress progress) {
  out << "t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us,buttons,sent_x,sent_y,"
         "sent_z,safety,tick,hip_qw,hip_qx,hip_qy,hip_qz,torque_x,torque_y,torque_z,sent_torque_x,sent_torque_y,"
         "sent_torque_z,event\n";
  auto event = recording.events().begin();
  std::string lines;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    addTick(lines, recording[i]);
    std::string happened;
    for (; event != recording.events().end() && event->tick <= recording[i].tick; ++event)
      happened += (happened.empty() ? "" : "; ") + event->text;
    if (!happened.empty()) addText(lines, happened);
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
