// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/RecordingBytes.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>

namespace handwheel {

namespace {

static_assert(std::endian::native == std::endian::little, "bytes are copied as they are");

constexpr std::string_view kMagic = "HWFR";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kTickBytes = 37 * sizeof(double) + sizeof(std::uint64_t) + 2 * sizeof(std::uint32_t);

// Flags of a tick; the bits of SafetyAction are above them.
constexpr std::uint32_t kRestart = 1, kContact = 2, kFresh = 4, kSoftened = 8, kSource = 16;
constexpr int kStatusShift = 5, kActionsShift = 8;  // three bits for the status

// Visits every double of a tick, in the order of the format, for writing and reading alike.
template <class Tick, class Visit>
void forEachDouble(Tick& t, Visit visit) {
  const auto each = [&](auto&& vector) {
    for (auto& x : vector) visit(x);
  };
  each(t.tip.position);
  each(t.tip.orientation.coeffs());
  each(t.tip.velocity);
  visit(t.tip.gripper);
  visit(t.tip.time);
  visit(t.tip.period);
  visit(t.tip.stiffnessLimit);
  visit(t.tip.dampingLimit);
  each(t.felt.force);
  each(t.felt.torque);
  visit(t.felt.gripper);
  each(t.felt.proxy);
  visit(t.felt.stiffness);
  each(t.sent.force);
  each(t.sent.torque);
  visit(t.sent.gripper);
  each(t.devicePosition);
}

template <class Number>
void put(std::string& bytes, Number value) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &value, sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

void putTick(std::string& bytes, const RecordedTick& tick) {
  forEachDouble(tick, [&](double value) { put(bytes, value); });
  put(bytes, static_cast<double>(tick.microseconds));
  put(bytes, tick.tick);
  put(bytes, tick.tip.buttons);
  std::uint32_t flags = tick.actions << kActionsShift | static_cast<std::uint32_t>(tick.status) << kStatusShift;
  flags |= (tick.tip.isRestart ? kRestart : 0) | (tick.felt.isContact ? kContact : 0);
  flags |= (tick.felt.isFresh ? kFresh : 0) | (tick.felt.isSoftened ? kSoftened : 0) | (tick.hasSource ? kSource : 0);
  put(bytes, flags);
}

// Reads numbers from the front; the caller has checked that they exist.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : m_rest(bytes) {}

  template <class Number>
  Number take() {
    Number value;
    std::memcpy(&value, m_rest.data(), sizeof(Number));
    m_rest.remove_prefix(sizeof(Number));
    return value;
  }
  std::string_view takeText(std::size_t length) {
    const std::string_view text = m_rest.substr(0, length);
    m_rest.remove_prefix(length);
    return text;
  }
  std::size_t left() const { return m_rest.size(); }

 private:
  std::string_view m_rest;
};

Error truncated(const char* what, std::uint64_t expected, std::uint64_t found) {
  return {ErrorCode::DataTruncated, {what, std::to_string(expected), std::to_string(found)}, {}, {}};
}

RecordedTick takeTick(Reader& reader) {
  RecordedTick tick;
  forEachDouble(tick, [&](double& value) { value = reader.take<double>(); });
  tick.microseconds = static_cast<float>(reader.take<double>());
  tick.tick = reader.take<std::uint64_t>();
  tick.tip.buttons = reader.take<std::uint32_t>();
  const auto flags = reader.take<std::uint32_t>();
  tick.tip.isRestart = flags & kRestart;
  tick.felt.isContact = flags & kContact;
  tick.felt.isFresh = flags & kFresh;
  tick.felt.isSoftened = flags & kSoftened;
  tick.hasSource = flags & kSource;
  const std::uint32_t status = flags >> kStatusShift & 7u;
  tick.status = static_cast<DeviceStatus>(std::min(status, static_cast<std::uint32_t>(DeviceStatus::Failed)));
  tick.actions = flags >> kActionsShift;
  return tick;
}

bool isSomewhere(const TipState& tip) {
  return tip.position.allFinite() && tip.orientation.coeffs().allFinite() && tip.velocity.allFinite() &&
         std::isfinite(tip.time);
}

Status readEvents(Reader& reader, std::uint32_t count, Recording& recording) {
  constexpr std::size_t kHead = sizeof(std::uint64_t) + sizeof(std::uint32_t);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (reader.left() < kHead) return truncated("events", count, i);
    const auto tick = reader.take<std::uint64_t>();
    const auto length = reader.take<std::uint32_t>();
    if (reader.left() < length) return truncated("events", count, i);
    recording.addEvent({tick, std::string(reader.takeText(length))});
  }
  return Done{};
}

}  // namespace

std::string recordingBytes(const Recording& recording) {
  return recordingBytes(recording, 0, recording.size());
}

std::string recordingBytes(const Recording& recording, std::size_t first, std::size_t last) {
  assert(first <= last && last <= recording.size());
  const std::vector<RecordedEvent>& all = recording.events();
  const auto isBefore = [](const RecordedEvent& event, std::uint64_t tick) { return event.tick <= tick; };
  const auto endAt = [&](std::size_t tick) {  // end of the events up to before this tick
    if (tick == recording.size()) return all.end();
    return tick == 0 ? all.begin() : std::lower_bound(all.begin(), all.end(), recording[tick - 1].tick, isBefore);
  };
  const auto begin = first == 0 ? all.begin() : endAt(first), end = endAt(last);
  std::string bytes(kMagic);
  bytes.reserve((last - first) * kTickBytes + 4096);
  put(bytes, kVersion);
  put(bytes, static_cast<std::uint32_t>(end - begin));
  put(bytes, static_cast<std::uint64_t>(last - first));
  for (auto event = begin; event < end; ++event) {
    put(bytes, event->tick);
    put(bytes, static_cast<std::uint32_t>(event->text.size()));
    bytes += event->text;
  }
  for (std::size_t i = first; i < last; ++i) putTick(bytes, recording[i]);
  return bytes;
}

Result<Recording> recordingFromBytes(std::string_view bytes) {
  constexpr std::size_t kHead = kMagic.size() + 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t);
  if (!bytes.starts_with(kMagic)) return Error{ErrorCode::HeaderMalformed, {std::string(kMagic)}, {}, {}};
  if (bytes.size() < kHead) return truncated("bytes", kHead, bytes.size());
  Reader reader(bytes.substr(kMagic.size()));
  const auto version = reader.take<std::uint32_t>();
  if (version > kVersion)
    return Error{ErrorCode::VersionNewer, {std::to_string(version), std::to_string(kVersion)}, {}, {}};
  const auto events = reader.take<std::uint32_t>();
  const auto ticks = reader.take<std::uint64_t>();
  Recording recording;
  if (const Status status = readEvents(reader, events, recording); !status) return status.error();
  const std::size_t there = reader.left() / kTickBytes;
  if (there < ticks) return truncated("ticks", ticks, there);
  if (reader.left() != ticks * kTickBytes)
    return Error{ErrorCode::CountMismatch, {"ticks", std::to_string(ticks), std::to_string(there)}, {}, {}};
  for (std::uint64_t i = 0; i < ticks; ++i) {
    const RecordedTick tick = takeTick(reader);
    if (!isSomewhere(tick.tip)) {
      const auto offset = static_cast<std::uint64_t>(bytes.size() - reader.left() - kTickBytes);
      return Error{ErrorCode::NumberNotFinite, {"nan"}, InputPosition::byte(offset), {}};
    }
    recording.add(tick);
  }
  return recording;
}

}  // namespace handwheel
